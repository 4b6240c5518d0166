/** Whether the window is large enough, and how it can be made so. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import type { ScreenRules } from "../api";
import { press, sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

export function largeEnough(rules: ScreenRules): boolean {
  return innerWidth >= rules.least_width_px && innerHeight >= rules.least_height_px;
}

/** Shown where the window is too small, until it is not or the participant goes on with it. */
export function windowPage(words: Words, rules: ScreenRules): Page<null> {
  const sizes = () => ({
    wide: rules.least_width_px,
    high: rules.least_height_px,
    width: innerWidth,
    height: innerHeight,
  });
  return {
    name: "window",
    draw(into, done) {
      const now = element("p", { class: "now", role: "status" });
      const go = button(words.window_anyway, () => done(null));
      const look = () => {
        const enough = largeEnough(rules);
        now.textContent = enough ? words.window_large : fill(words.window_now, sizes());
        go.textContent = enough ? words.go_on : words.window_anyway;
        go.className = enough ? "main" : "";
      };
      const explained = element("p", {}, fill(words.window_small, sizes()));
      sheet(into, words.window_title, [explained, now], [go]);
      look();
      window.addEventListener("resize", look);
      return () => window.removeEventListener("resize", look);
    },
    play: (into) => press(into, ".actions button"),
  };
}
