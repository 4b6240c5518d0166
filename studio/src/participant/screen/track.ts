/** What the left eye looks at, and what vanishes beside it. */

import { element } from "../../shared/dom";

/** The dot starts this near the square. */
const START_MM = 30;
const SPEED_MM_PER_S = 16;
/** Left free at either end. */
export const MARGIN_PX = 24;

/** The square that is looked at, and the dot that leaves it. */
export class Track {
  readonly root: HTMLElement;
  moving = false;
  private readonly dot = element("span", { class: "dot" });
  private apart_px = 0;
  private frame = 0;

  constructor(
    private readonly px_per_mm: number,
    private readonly missed: () => void,
  ) {
    const square = element("span", { class: "fixed" });
    this.root = element("div", { class: "track", "aria-hidden": "true" }, square, this.dot);
    this.place();
  }

  start(): void {
    this.moving = true;
    const began_ms = performance.now();
    const step = (now_ms: number) => {
      this.apart_px = (START_MM + (SPEED_MM_PER_S * (now_ms - began_ms)) / 1000) * this.px_per_mm;
      this.place();
      if (this.apart_px < this.root.clientWidth - 2 * MARGIN_PX) {
        this.frame = requestAnimationFrame(step);
      } else {
        this.stop();
        this.missed();
      }
    };
    this.frame = requestAnimationFrame(step);
  }

  /** Put the dot back; gives how far it was from the square. */
  stop(): number {
    cancelAnimationFrame(this.frame);
    this.moving = false;
    const apart_mm = this.apart_px / this.px_per_mm;
    this.apart_px = START_MM * this.px_per_mm;
    this.place();
    return apart_mm;
  }

  private place(): void {
    this.dot.style.transform = `translateX(${-this.apart_px}px)`;
  }
}
