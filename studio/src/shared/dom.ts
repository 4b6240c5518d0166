/** Elements made from script: never from text, so that nobody's words become markup. */

import { printable } from "./printable";

type Attributes = Record<string, string | number | boolean>;
type Child = Node | string;

/**
 * An element with attributes and children. `true` sets an attribute without a value, `false` leaves
 * it out; text is text.
 */
export function element<K extends keyof HTMLElementTagNameMap>(
  name: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === false) continue;
    made.setAttribute(key, value === true ? "" : String(value));
  }
  made.append(...children.map((child) => (typeof child === "string" ? printable(child) : child)));
  return made;
}

/** A button that says `label` and does `act` when pressed. */
export function button(label: string, act: () => void, attributes: Attributes = {}) {
  const made = element("button", { type: "button", ...attributes }, label);
  made.addEventListener("click", act);
  return made;
}

/** Text as paragraphs: a blank line begins a new one. */
export function paragraphs(text: string): HTMLParagraphElement[] {
  return text
    .split(/\n\s*\n/)
    .map((part) => part.trim())
    .filter((part) => part !== "")
    .map((part) => element("p", {}, part));
}
