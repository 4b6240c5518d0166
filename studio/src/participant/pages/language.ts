/** Which language the sitting is in. */

import { button, element } from "../../shared/dom";
import { NAMES } from "../../shared/language";
import type { Language } from "../../shared/language";
import { press } from "../sheet";
import type { Page } from "../stage";
import { WORDS } from "../words/words";

/** Asked in every language offered; `first` is the one that the browser prefers. */
export function languagePage(offered: readonly Language[], first: Language): Page<Language> {
  return {
    name: "language",
    draw(into, done) {
      const title = offered.map((language) => WORDS[language].language).join(" / ");
      const choices = offered.map((language) =>
        button(NAMES[language], () => done(language), {
          lang: language,
          class: language === first ? "main" : "quiet",
        }),
      );
      into.append(
        element(
          "div",
          { class: "sheet" },
          element("h1", {}, title),
          element("div", { class: "languages" }, ...choices),
        ),
      );
    },
    play: (into) => press(into, "button.main"),
  };
}
