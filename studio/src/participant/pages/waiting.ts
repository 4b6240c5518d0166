/** Pages that leave by themselves, when something has come or gone. */

import { element } from "../../shared/dom";
import { fill } from "../../shared/language";
import { progress } from "../progress";
import { sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

/** Shown while the pictures come. */
export function loadingPage(
  words: Words,
  fetching: (told: (here: number, all: number) => void) => Promise<void>,
): Page<Loaded> {
  return {
    name: "loading",
    draw(into, done) {
      const place = element("div");
      const told = (here: number, all: number) => {
        place.replaceChildren(progress(fill(words.loading_of, { here, all }), here / all));
      };
      sheet(into, words.loading, [place]);
      fetching(told).then(
        () => done({ problem: null }),
        (problem: unknown) => done({ problem }),
      );
    },
  };
}

/** How it went; a reason is thrown by whoever shows the page. */
interface Loaded {
  problem: unknown;
}

/** Shown while the last answers are on their way. */
export function sendingPage(words: Words, waiting: () => number, all: Promise<void>): Page<null> {
  return {
    name: "sending",
    draw(into, done) {
      const text = element("p", { role: "status" });
      const tell = () => (text.textContent = fill(words.sending, { n: waiting() }));
      sheet(into, words.sending_title, [text]);
      tell();
      const clock = setInterval(tell, 500);
      void all.then(() => done(null));
      return () => clearInterval(clock);
    },
  };
}
