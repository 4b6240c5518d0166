/** How far the eyes are from the screen: by the blind spot of the left eye, or typed in. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import type { ScreenRules } from "../api";
import { mayHaveKeys } from "../keyboard";
import { press, sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";
import { MARGIN_PX, Track } from "./track";

/** From the line of sight to the blind spot's near edge, degrees (Li et al. 2020, Virtual Chinrest). */
const BLIND_SPOT_DEG = 13.5;
/** How often the dot is followed. */
const TRIES = 3;
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
  return distance_mm((window_px - 2 * MARGIN_PX) / px_per_mm) > NEAREST_MM;
}

type Limits = Pick<ScreenRules, "least_distance_mm" | "most_distance_mm">;

/** Whether somebody can sit so far away, by the study's rules; where not, they are asked again. */
export function plausible(found_mm: number, limits: Limits): boolean {
  return limits.least_distance_mm <= found_mm && found_mm <= limits.most_distance_mm;
}

/** The test; ends with null where somebody would rather type. */
export function blindSpotPage(
  words: Words,
  step: string,
  px_per_mm: number,
  limits: Limits,
): Page<number[] | null> {
  return {
    name: "blind-spot",
    draw(into, done) {
      const tries_mm: number[] = [];
      let doubted = false;
      const count = element("p", { class: "now", role: "status" });
      const tell = (told: string) => {
        const cm = Math.round(median(tries_mm) / 10);
        if (told === words.distance_again) tries_mm.length = 0;
        count.textContent = fill(told, { n: tries_mm.length + 1, all: TRIES, cm });
        go.textContent = words.distance_start;
      };
      const track = new Track(px_per_mm, () => tell(words.distance_missed));
      const next = () => {
        if (!track.moving) {
          track.start();
          go.textContent = words.distance_gone;
          return;
        }
        tries_mm.push(distance_mm(track.stop()));
        if (tries_mm.length < TRIES) return tell(words.distance_try);
        if (doubted || plausible(median(tries_mm), limits)) return done(tries_mm);
        doubted = true;
        tell(words.distance_again);
      };
      const go = button("", next, { class: "main" });
      const typed = button(words.distance_type, () => done(null), { class: "quiet" });
      const text = mayHaveKeys() ? words.distance : words.distance_touch;
      const body = [element("p", {}, text), track.root, count];
      sheet(into, words.distance_title, body, [go, typed], [step]);
      tell(words.distance_try);
      go.focus();
      return () => track.stop();
    },
    play: (into) => press(into, "button.quiet"),
  };
}

export function typedPage(words: Words, step: string, limits: Limits): Page<number | null> {
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
      let doubted_cm = NaN;
      const take = () => {
        const typed_cm = field.valueAsNumber;
        const possible = typed_cm >= 10 && typed_cm <= 300;
        const sure = typed_cm === doubted_cm || plausible(10 * typed_cm, limits);
        if (possible && sure) return done(typed_cm * 10);
        doubted_cm = typed_cm;
        missing.textContent = fill(possible ? words.distance_sure : words.distance_range, {
          cm: typed_cm,
        });
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
