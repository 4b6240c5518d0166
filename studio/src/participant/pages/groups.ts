/** What the study asks of a participant: a value for each factor that is recorded. */

import { button, element } from "../../shared/dom";
import { said } from "../../shared/language";
import type { Language } from "../../shared/language";
import type { Factor } from "../api";
import { press, sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

const MOST_BUTTONS = 7;

export function groupsPage(
  words: Words,
  language: Language,
  factors: readonly Factor[],
): Page<Record<string, string>> {
  return {
    name: "groups",
    draw(into, done) {
      const form = element("form", { novalidate: true });
      const missing = element("p", { class: "missing", role: "alert" });
      form.append(
        ...factors.map((factor, place) =>
          factor.choices.length > MOST_BUTTONS
            ? list(words, language, factor, place)
            : buttons(language, factor, place),
        ),
        missing,
      );
      const answers = () => {
        const given = new FormData(form);
        const chosen = factors.map(
          ({ name }, place) => [name, given.get(`factor-${place}`)] as const,
        );
        const open = chosen.findIndex(([, value]) => typeof value !== "string" || value === "");
        if (open < 0) return done(Object.fromEntries(chosen) as Record<string, string>);
        missing.textContent = words.groups_missing;
        form.querySelector<HTMLElement>(`[name="factor-${open}"]`)?.focus();
      };
      form.addEventListener("submit", (event) => event.preventDefault());
      sheet(into, words.groups_title, [form], [button(words.go_on, answers, { class: "main" })]);
    },
    play(into) {
      into.querySelectorAll<HTMLElement>("fieldset").forEach((one) => press(one, "input"));
      into.querySelectorAll("select").forEach((one) => (one.selectedIndex = 1));
      press(into, "button.main");
    },
  };
}

function buttons(language: Language, factor: Factor, place: number): HTMLElement {
  const choices = factor.choices.map(({ value, text }) => {
    const input = element("input", { type: "radio", name: `factor-${place}`, value });
    return element("label", { class: "tick" }, input, said(text, language));
  });
  return element(
    "fieldset",
    {},
    element("legend", {}, said(factor.question, language)),
    ...choices,
  );
}

function list(words: Words, language: Language, factor: Factor, place: number): HTMLElement {
  const id = `factor-${place}`;
  const choices = factor.choices.map(({ value, text }) =>
    element("option", { value }, said(text, language)),
  );
  const none = element("option", { value: "" }, words.groups_choose);
  return element(
    "div",
    { class: "field" },
    element("label", { for: id }, said(factor.question, language)),
    element("select", { id, name: id }, none, ...choices),
  );
}
