/** A page to read: a title, what it says, and what can be done. */

import { button, element, paragraphs } from "../shared/dom";
import type { Page } from "./stage";

type Child = Node | string;

/** Put a page's parts together. `above` stands over the title, small. */
export function sheet(
  into: HTMLElement,
  title: string,
  body: readonly Child[],
  actions: readonly HTMLElement[] = [],
  above: readonly Child[] = [],
): void {
  into.append(
    element(
      "div",
      { class: "sheet" },
      ...(above.length > 0 ? [element("div", { class: "above" }, ...above)] : []),
      element("h1", {}, title),
      ...body,
      ...(actions.length > 0 ? [element("div", { class: "actions" }, ...actions)] : []),
    ),
  );
}

/** A page with words alone, left by one of its buttons; the first is the one to go on with. */
export function reading<T extends string>(
  name: string,
  title: string,
  text: readonly string[],
  actions: readonly (readonly [T, string])[],
): Page<T> {
  return {
    name,
    draw(into, done) {
      const buttons = actions.map(([result, label], place) =>
        button(label, () => done(result), { class: place === 0 ? "main" : "quiet" }),
      );
      sheet(into, title, text.flatMap(paragraphs), buttons);
    },
    play: (into) => press(into, ".actions button"),
  };
}

/** Click what a simulated participant would. */
export function press(into: HTMLElement, selector: string): void {
  const found = into.querySelector<HTMLElement>(selector);
  if (found === null) throw new Error(`there is no ${selector} to press`);
  found.click();
}
