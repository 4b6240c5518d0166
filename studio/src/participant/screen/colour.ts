/** Which digit is seen in each plate. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import { mayHaveKeys } from "../keyboard";
import { sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";
import type { Share } from "./content";
import { plate, platesOf } from "./plates";
import { listen, Series } from "./series";

const DIGITS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9] as const;

export function colourPage(words: Words, step: string, seed: number): Page<Share> {
  const plates = platesOf(seed);
  return {
    name: "colour",
    draw(into, done) {
      const place = element("div", { role: "img", "aria-label": words.colour_question });
      const count = element("p", { class: "now", role: "status" });
      const take = (digit: number | null) => series.take(digit);
      const digits = DIGITS.map((digit) => button(String(digit), () => take(digit)));
      const none = button(words.colour_none, () => take(null), { class: "none" });
      const choices = element("div", { class: "digits" }, ...digits, none);
      const body = [
        element("p", {}, mayHaveKeys() ? words.colour : words.colour_touch),
        element("p", { class: "soft" }, words.no_medical),
        element("div", { class: "plates" }, place, choices),
        count,
      ];
      sheet(into, words.colour_title, body, [], [step]);
      const show = (at: number) => {
        const shown = plates[at];
        if (shown !== undefined) place.replaceChildren(plate(shown));
        count.textContent = fill(words.colour_of, { n: at + 1, all: plates.length });
      };
      const wanted = plates.map(({ digit }) => digit);
      const series = new Series(wanted, show, done);
      return listen((key) => (/^\d$/.test(key) ? Number(key) : undefined), take);
    },
    play(into) {
      const digits = into.querySelectorAll<HTMLElement>(".digits button");
      for (const { digit } of plates) digits[digit]?.click();
    },
  };
}
