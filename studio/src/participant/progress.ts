/** How far a participant is: as words, and as a bar. */

import { element } from "../shared/dom";

/** `share`: 0 to 1. */
export function progress(words: string, share: number): HTMLElement {
  const done = element("span");
  done.style.width = `${Math.round(100 * share)}%`;
  const bar = element(
    "span",
    {
      class: "bar",
      role: "progressbar",
      "aria-label": words,
      "aria-valuemin": 0,
      "aria-valuemax": 100,
      "aria-valuenow": Math.round(100 * share),
    },
    done,
  );
  return element("div", { class: "progress" }, element("span", {}, words), bar);
}
