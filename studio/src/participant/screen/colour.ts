/** Which digit is seen in each plate. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import { sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";
import type { Share } from "./content";
import { plate, platesOf } from "./plates";

const DIGITS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9] as const;

export function colourPage(words: Words, step: string, seed: number): Page<Share> {
  const plates = platesOf(seed);
  return {
    name: "colour",
    draw(into, done) {
      let at = 0;
      let right = 0;
      const place = element("div", { role: "img", "aria-label": words.colour_question });
      const count = element("p", { class: "now", role: "status" });
      const show = () => {
        const shown = plates[at];
        if (shown !== undefined) place.replaceChildren(plate(shown));
        count.textContent = fill(words.colour_of, { n: at + 1, all: plates.length });
      };
      const take = (digit: number | null) => {
        if (digit === plates[at]?.digit) right += 1;
        at += 1;
        if (at === plates.length) done({ right, of: plates.length });
        else show();
      };
      const press = (event: KeyboardEvent) => {
        if (/^\d$/.test(event.key) && !event.repeat) take(Number(event.key));
      };
      const digits = DIGITS.map((digit) => button(String(digit), () => take(digit)));
      const none = button(words.colour_none, () => take(null), { class: "none" });
      const body = [
        element("p", {}, words.colour),
        element("p", { class: "soft" }, words.no_medical),
        element(
          "div",
          { class: "plates" },
          place,
          element("div", { class: "digits" }, ...digits, none),
        ),
        count,
      ];
      sheet(into, words.colour_title, body, [], [step]);
      show();
      document.addEventListener("keydown", press);
      return () => document.removeEventListener("keydown", press);
    },
    play(into) {
      const digits = into.querySelectorAll<HTMLElement>(".digits button");
      for (const { digit } of plates) digits[digit]?.click();
    },
  };
}
