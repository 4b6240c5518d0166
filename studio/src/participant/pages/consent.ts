/** Whether somebody takes part: nothing is sent to the server before they agree. */

import { button, element, paragraphs } from "../../shared/dom";
import { NAMES } from "../../shared/language";
import type { Language } from "../../shared/language";
import { press, sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

type Consent = "agree" | "decline" | Language;

/** `others`: the languages that one can change to. */
export function consentPage(
  words: Words,
  text: string,
  others: readonly Language[],
  demo: boolean,
): Page<Consent> {
  return {
    name: "consent",
    draw(into, done) {
      const box = element("input", {
        type: "checkbox",
        id: "agreed",
        "aria-describedby": "missing",
      });
      const missing = element("p", { class: "missing", id: "missing", role: "alert" });
      const agree = button(
        words.consent_agree,
        () => {
          if (box.checked) done("agree");
          else {
            missing.textContent = words.consent_missing;
            box.focus();
          }
        },
        { class: "main" },
      );
      const decline = button(words.consent_decline, () => done("decline"), { class: "quiet" });
      const label = element("label", { class: "tick", for: "agreed" }, box, words.consent_box);
      const body = [...paragraphs(text), label, missing];
      sheet(into, words.consent_title, body, [agree, decline], above(words, others, demo, done));
    },
    play(into) {
      press(into, "#agreed");
      press(into, "button.main");
    },
  };
}

/** Over the title: that this is a demonstration, where it is, and the other languages. */
function above(
  words: Words,
  others: readonly Language[],
  demo: boolean,
  change: (to: Language) => void,
): HTMLElement[] {
  const switches = others.map((language) =>
    button(NAMES[language], () => change(language), { lang: language, class: "small" }),
  );
  return demo ? [element("span", { class: "demo" }, words.demo), ...switches] : switches;
}
