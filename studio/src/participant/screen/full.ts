/** Full screen, which a browser enters only by a participant's own press. */

import { button, element } from "../../shared/dom";
import { mayHaveKeys } from "../keyboard";
import { press, sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

/** Whether this browser has it at all; telephones often do not. */
export function canFill(): boolean {
  return document.fullscreenEnabled && document.fullscreenElement === null;
}

/** Go to full screen; a browser that refuses is no reason to stop. */
export async function fillScreen(): Promise<void> {
  if (canFill()) await document.documentElement.requestFullscreen().catch(() => undefined);
}

export function fullPage(words: Words, step: string): Page<null> {
  return {
    name: "full",
    draw(into, done) {
      const enter = button(words.full_enter, () => void fillScreen().then(() => done(null)), {
        class: "main",
      });
      const without = button(words.full_without, () => done(null), { class: "quiet" });
      const text = [
        element("p", {}, words.full),
        element("p", {}, mayHaveKeys() ? words.full_leave : words.full_leave_touch),
      ];
      sheet(into, words.full_title, text, [enter, without], [step]);
    },
    play: (into) => press(into, "button.quiet"),
  };
}
