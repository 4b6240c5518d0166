/** The size of a CSS pixel, by a bank card held against the screen. */

import { button, element } from "../../shared/dom";
import { press, sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

/** ISO/IEC 7810, ID-1: width and height of every bank card. */
export const CARD_MM = { width: 85.6, height: 53.98 };

/** From a large monitor far away to a small telephone. */
const LEAST_PX_PER_MM = 1.5;
const MOST_PX_PER_MM = 12;

/** Where the window is narrower, the card is held upright. */
const NARROW_PX = 640;

/** Which side of the card lies across. */
export function across_mm(window_px: number): number {
  return window_px < NARROW_PX ? CARD_MM.height : CARD_MM.width;
}

/** The size of a pixel, or null without a card. */
export function cardPage(words: Words, step: string): Page<number | null> {
  return {
    name: "card",
    draw(into, done) {
      const wide_mm = across_mm(innerWidth);
      const drawing = new Drawing(words, wide_mm);
      const finish = () => done(drawing.px_per_mm);
      const measured = button(words.card_done, finish, { class: "main" });
      const none = button(words.card_none, () => done(null), { class: "quiet" });
      const upright = wide_mm === CARD_MM.height ? [element("p", {}, words.card_upright)] : [];
      const body = [element("p", {}, words.card), ...upright, drawing.slider, drawing.place];
      sheet(into, words.card_title, body, [measured, none], [step]);
      drawing.slider.focus();
    },
    play: (into) => press(into, "button.main"),
  };
}

/** The card as drawn, with its slider and its handle. */
class Drawing {
  readonly slider: HTMLInputElement;
  readonly place: HTMLElement;
  private readonly card = element("div", { class: "card" });

  constructor(
    words: Words,
    private readonly wide_mm: number,
  ) {
    const most_px = Math.min(innerWidth - 48, wide_mm * MOST_PX_PER_MM);
    this.slider = element("input", {
      type: "range",
      "aria-label": words.card_slider,
      min: wide_mm * LEAST_PX_PER_MM,
      max: most_px,
      step: 0.5,
    });
    this.slider.value = String((wide_mm * 96) / 25.4);
    this.slider.addEventListener("input", () => this.draw());
    const handle = element("span", { class: "handle", "aria-hidden": "true" });
    handle.addEventListener("pointerdown", (event) => this.drag(event, handle));
    this.card.append(element("span", { class: "chip" }), handle);
    this.place = element("div", { class: "card-place" }, this.card);
    this.draw();
  }

  get px_per_mm(): number {
    return Number(this.slider.value) / this.wide_mm;
  }

  private draw(): void {
    const high_mm = CARD_MM.width + CARD_MM.height - this.wide_mm;
    this.card.style.width = `${this.px_per_mm * this.wide_mm}px`;
    this.card.style.height = `${this.px_per_mm * high_mm}px`;
    this.card.style.borderRadius = `${this.px_per_mm * 3.18}px`;
  }

  private drag(down: PointerEvent, handle: HTMLElement): void {
    down.preventDefault();
    handle.setPointerCapture(down.pointerId);
    const from_px = Number(this.slider.value);
    const move = (event: PointerEvent) => {
      this.slider.value = String(from_px + event.clientX - down.clientX);
      this.draw();
    };
    handle.addEventListener("pointermove", move);
    const end = () => handle.removeEventListener("pointermove", move);
    handle.addEventListener("lostpointercapture", end, { once: true });
  }
}
