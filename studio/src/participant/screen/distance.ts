/** How far the eyes are from the screen: by the blind spot of the left eye, or typed in. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import { press, sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

/** From the line of sight to the blind spot's near edge, degrees (Li et al. 2020, Virtual Chinrest). */
export const BLIND_SPOT_DEG = 13.5;
/** How often the dot is followed. */
export const TRIES = 3;
/** The dot starts this near the square. */
const START_MM = 30;
const SPEED_MM_PER_S = 16;
const MARGIN_PX = 24;
/** The least distance that a window must be able to measure. */
const NEAREST_MM = 300;

export interface Distance {
  distance_mm: number | null;
  by: "blind-spot" | "typed" | "none";
  tries_mm: number[];
}

/** The distance at which `apart_mm` on the screen reaches from the line of sight to the blind spot. */
export function distance_mm(apart_mm: number): number {
  return apart_mm / Math.tan((BLIND_SPOT_DEG * Math.PI) / 180);
}

/** The middle one of some numbers. */
export function median(values: readonly number[]): number {
  const sorted = [...values].sort((one, other) => one - other);
  const middle = Math.floor(sorted.length / 2);
  const upper = sorted[middle] ?? NaN;
  return sorted.length % 2 === 1 ? upper : ((sorted[middle - 1] ?? NaN) + upper) / 2;
}

/** Whether a window is wide enough for the dot to reach the blind spot from near by. */
export function wideEnough(window_px: number, px_per_mm: number): boolean {
  return (window_px - 2 * MARGIN_PX) / px_per_mm > NEAREST_MM * Math.tan(0.2356);
}

/** The test; ends with null where somebody would rather type. */
export function blindSpotPage(
  words: Words,
  step: string,
  px_per_mm: number,
): Page<number[] | null> {
  return {
    name: "blind-spot",
    draw(into, done) {
      const tries_mm: number[] = [];
      const count = element("p", { class: "now", role: "status" });
      const track = new Track(px_per_mm, () => {
        count.textContent = words.distance_missed;
        go.textContent = words.distance_start;
      });
      const tell = () => {
        const places = { n: tries_mm.length + 1, all: TRIES };
        count.textContent = fill(words.distance_try, places);
      };
      const go = button(
        words.distance_start,
        () => {
          if (!track.moving) {
            track.start();
            go.textContent = words.distance_gone;
            return;
          }
          tries_mm.push(distance_mm(track.stop()));
          if (tries_mm.length === TRIES) return done(tries_mm);
          go.textContent = words.distance_start;
          tell();
        },
        { class: "main" },
      );
      const typed = button(words.distance_type, () => done(null), { class: "quiet" });
      const body = [element("p", {}, words.distance), track.root, count];
      sheet(into, words.distance_title, body, [go, typed], [step]);
      tell();
      go.focus();
      return () => track.stop();
    },
    play: (into) => press(into, "button.quiet"),
  };
}

/** The square that is looked at, and the dot that leaves it. */
class Track {
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

export function typedPage(words: Words, step: string): Page<number | null> {
  return {
    name: "distance",
    draw(into, done) {
      const field = element("input", {
        type: "number",
        id: "distance",
        min: 10,
        max: 300,
        inputmode: "numeric",
        "aria-describedby": "missing",
      });
      const missing = element("p", { class: "missing", id: "missing", role: "alert" });
      const take = () => {
        const typed_cm = field.valueAsNumber;
        if (typed_cm >= 10 && typed_cm <= 300) return done(typed_cm * 10);
        missing.textContent = words.distance_range;
        field.focus();
      };
      field.addEventListener("keydown", (event) => event.key === "Enter" && take());
      const label = element("label", { for: "distance" }, words.distance_cm);
      const body = [
        element("p", {}, words.distance_typed),
        element("div", { class: "field" }, label, field),
        missing,
      ];
      const unknown = button(words.distance_unknown, () => done(null), { class: "quiet" });
      const go = button(words.go_on, take, { class: "main" });
      sheet(into, words.distance_title, body, [go, unknown], [step]);
      field.focus();
    },
    play(into) {
      const field = into.querySelector<HTMLInputElement>("#distance");
      if (field !== null) field.value = "60";
      press(into, "button.main");
    },
  };
}
