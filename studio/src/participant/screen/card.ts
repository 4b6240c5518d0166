/** The size of a CSS pixel, by a bank card held against the screen. */

import { button, element } from "../../shared/dom";
import { mayHaveKeys } from "../keyboard";
import { press } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

/** ISO/IEC 7810, ID-1: width and height of every bank card. */
export const CARD_MM = { width: 85.6, height: 53.98 };

/** From a large monitor far away to a small telephone. */
const LEAST_PX_PER_MM = 1.5;
const MOST_PX_PER_MM = 12;

/** Where the window is narrower or lower, the card is held upright: so it fits a telephone. */
const NARROW_PX = 640;
const LOW_PX = 500;

/** Of the telephones with the largest pixels for their size: on these a card may not fit. */
const LARGE_PX_PER_MM = 6.5;

/** Which side of the card lies across. */
export function across_mm(width_px: number, height_px: number): number {
  const small = width_px < NARROW_PX || height_px < LOW_PX;
  return small ? CARD_MM.height : CARD_MM.width;
}

/** The size of a pixel, or null without a card. */
export function cardPage(words: Words, step: string): Page<number | null> {
  return {
    name: "card",
    draw(into, done) {
      const upright = element("p", {}, words.card_upright);
      const turn = element("p", {}, words.card_turn);
      const drawing = new Drawing(words, upright, turn);
      const finish = () => done(drawing.px_per_mm);
      const measured = button(words.card_done, finish, { class: "main" });
      const none = button(words.card_none, () => done(null), { class: "quiet" });
      const text = element("p", {}, mayHaveKeys() ? words.card : words.card_touch);
      const above = element("div", { class: "above" }, step);
      const title = element("h1", {}, words.card_title);
      const actions = element("div", { class: "actions" }, measured, none);
      into.append(
        element(
          "div",
          { class: "sheet" },
          element("div", { class: "said" }, above, title, text, upright, turn),
          drawing.place,
          element("div", { class: "controls" }, drawing.slider, actions),
        ),
      );
      drawing.slider.focus({ preventScroll: true });
      return drawing.fit();
    },
    play: (into) => press(into, "button.main"),
  };
}

/** The card as drawn, with its slider and its handle. */
class Drawing {
  readonly slider: HTMLInputElement;
  readonly place: HTMLElement;
  px_per_mm = 96 / 25.4;
  private readonly card = element("div", { class: "card" });
  private wide_mm = CARD_MM.width;

  constructor(
    words: Words,
    private readonly upright: HTMLElement,
    private readonly turn: HTMLElement,
  ) {
    this.slider = element("input", { type: "range", "aria-label": words.card_slider, step: 0.5 });
    this.slider.addEventListener("input", () => this.measure());
    const handle = element("span", { class: "handle", "aria-hidden": "true" });
    handle.addEventListener("pointerdown", (event) => this.drag(event, handle));
    this.card.append(element("span", { class: "chip" }), handle);
    this.place = element("div", { class: "card-place" }, this.card);
  }

  /** Follow the room that there is for the drawing; what it returns ends that. */
  fit(): () => void {
    const fill = () => {
      this.wide_mm = across_mm(innerWidth, innerHeight);
      this.upright.hidden = this.wide_mm === CARD_MM.width;
      const most_px = Math.min(this.place.clientWidth - 24, this.wide_mm * MOST_PX_PER_MM);
      const narrow = most_px < this.wide_mm * LARGE_PX_PER_MM;
      this.turn.hidden = !narrow || innerWidth > innerHeight;
      this.slider.min = String(this.wide_mm * LEAST_PX_PER_MM);
      this.slider.max = String(most_px);
      this.slider.value = String(this.wide_mm * this.px_per_mm);
      this.measure();
    };
    const room = new ResizeObserver(fill);
    room.observe(this.place);
    fill();
    return () => room.disconnect();
  }

  private measure(): void {
    this.px_per_mm = Number(this.slider.value) / this.wide_mm;
    const high_mm = CARD_MM.width + CARD_MM.height - this.wide_mm;
    this.card.style.width = `${this.px_per_mm * this.wide_mm}px`;
    this.card.style.height = `${this.px_per_mm * high_mm}px`;
    this.card.style.borderRadius = `${this.px_per_mm * 3.18}px`;
    // Of a card that is higher than the room, the upper end is out of sight, never the corner.
    const cut = this.card.offsetHeight + 24 > this.place.clientHeight;
    this.place.classList.toggle("cut", cut);
  }

  private drag(down: PointerEvent, handle: HTMLElement): void {
    down.preventDefault();
    handle.setPointerCapture(down.pointerId);
    const from_px = Number(this.slider.value);
    const move = (event: PointerEvent) => {
      this.slider.value = String(from_px + event.clientX - down.clientX);
      this.measure();
    };
    handle.addEventListener("pointermove", move);
    const end = () => handle.removeEventListener("pointermove", move);
    handle.addEventListener("lostpointercapture", end, { once: true });
  }
}
