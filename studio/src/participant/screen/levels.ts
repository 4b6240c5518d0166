/** Middle and dark tones: the exponent of the screen, and the darkest step that is seen. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import { press, sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

/** The grey codes that the slider goes through. */
const LEAST_CODE = 90;
const MOST_CODE = 240;
const START_CODE = 130;

/** Of the patches on black; the last one nobody misses on a working screen. */
const DARK_CODES = [2, 4, 6, 8, 12, 16, 24, 40] as const;
/** Kept where none of them is seen. */
const NONE_SEEN = 255;

/**
 * The exponent of a screen on which a grey of `code` is as bright as stripes half black, half white:
 * (code / 255) ** gamma = 1 / 2. Screens are no pure powers: an approximation.
 */
export function gammaOf(code: number): number {
  return Math.log(0.5) / Math.log(code / 255);
}

export function gammaPage(words: Words, step: string): Page<number> {
  return {
    name: "gamma",
    draw(into, done) {
      const slider = element("input", {
        type: "range",
        "aria-label": words.gamma_slider,
        min: LEAST_CODE,
        max: MOST_CODE,
        step: 1,
      });
      slider.value = String(START_CODE);
      const disc = element("span", { class: "disc" });
      const shade = () => {
        const code = slider.value;
        disc.style.background = `rgb(${code} ${code} ${code})`;
      };
      slider.addEventListener("input", shade);
      shade();
      const field = element("div", { class: "stripes", "aria-hidden": "true" }, stripes(264), disc);
      const same = button(words.gamma_done, () => done(gammaOf(Number(slider.value))), {
        class: "main",
      });
      sheet(
        into,
        words.gamma_title,
        [element("p", {}, words.gamma), field, slider],
        [same],
        [step],
      );
      slider.focus();
    },
    play(into) {
      const slider = into.querySelector<HTMLInputElement>("input");
      if (slider !== null) slider.value = "186";
      press(into, "button.main");
    },
  };
}

/** Rows of the screen's own pixels, black and white by turns, `side_px` CSS pixels a side. */
function stripes(side_px: number): HTMLCanvasElement {
  const side = Math.round(side_px * devicePixelRatio);
  const canvas = element("canvas", { width: side, height: side });
  canvas.style.width = canvas.style.height = `${side / devicePixelRatio}px`;
  const pen = canvas.getContext("2d");
  if (pen === null) return canvas;
  pen.fillStyle = "#000";
  pen.fillRect(0, 0, side, side);
  pen.fillStyle = "#fff";
  for (let row = 0; row < side; row += 2) pen.fillRect(0, row, side, 1);
  return canvas;
}

export function darkPage(words: Words, step: string): Page<number> {
  return {
    name: "dark",
    draw(into, done) {
      const patches = DARK_CODES.map((code, place) => {
        const patch = element("span", { class: "patch" });
        patch.style.background = `rgb(${code} ${code} ${code})`;
        const label = fill(words.dark_patch, { n: place + 1 });
        const choice = button("", () => done(code), { "aria-label": label });
        choice.append(patch, element("span", { "aria-hidden": "true" }, String(place + 1)));
        return choice;
      });
      const field = element("div", { class: "patches" }, ...patches);
      const none = button(words.dark_none, () => done(NONE_SEEN), { class: "quiet" });
      sheet(into, words.dark_title, [element("p", {}, words.dark), field], [none], [step]);
    },
    play: (into) => press(into, ".patches button:nth-child(3)"),
  };
}
