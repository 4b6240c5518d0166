/** A plain page of the pictures' grey, looked at until the eyes are used to it again. */

import { element } from "../../shared/dom";
import { fill } from "../../shared/language";
import type { Page } from "../stage";
import type { Words } from "../words/words";

const TICK_MS = 200;
/** The most that one tick counts: a computer that slept has shown nothing meanwhile. */
const MOST_MS = 1000;
/** How often what is left is told, also to those who do not want anything to move. */
const STEP_S = 1;
const CALM_STEP_S = 10;

/** Left by itself after `wanted_s` seconds in which it could be seen; nothing ends it earlier. */
export function adaptPage(words: Words, wanted_s: number): Page<null> {
  return {
    name: "adapt",
    draw(into, done) {
      const count = element("p", { class: "count", role: "timer" });
      const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
      const step_s = calm ? CALM_STEP_S : STEP_S;
      const tell = (left_s: number) => {
        const said = fill(words.adapt_left, { n: step_s * Math.ceil(left_s / step_s) });
        if (count.textContent !== said) count.textContent = said;
      };
      const text = element("h1", {}, words.adapt_text);
      into.append(element("div", { class: "adapting" }, text, count));
      let left_ms = 1000 * wanted_s;
      let before_ms = performance.now();
      tell(wanted_s);
      const clock = setInterval(() => {
        const now_ms = performance.now();
        if (!document.hidden) left_ms -= Math.min(MOST_MS, now_ms - before_ms);
        before_ms = now_ms;
        if (left_ms <= 0) done(null);
        else tell(left_ms / 1000);
      }, TICK_MS);
      return () => clearInterval(clock);
    },
  };
}
