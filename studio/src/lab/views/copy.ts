/** A button that copies. */

import { button } from "../../shared/dom";
import type { Desk } from "../desk";

const SHOWN_MS = 2500;

export function copyButton(desk: Desk, text: string, label?: string): HTMLButtonElement {
  const words = desk.speech.words.invitations;
  const named = label ?? words.copy;
  let timer = 0;
  const made = button(
    named,
    () => {
      void copied(text).then((done) => {
        made.textContent = done ? words.copied : words.not_copied;
        clearTimeout(timer);
        timer = window.setTimeout(() => {
          made.textContent = named;
        }, SHOWN_MS);
      });
    },
    { class: "small", "aria-live": "polite" },
  );
  return made;
}

/** Copies; where the browser has no clipboard for us, as over plain http, by the older way. */
async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = document.createElement("textarea");
    area.value = text;
    area.classList.add("sr-only");
    const before = document.activeElement;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    if (before instanceof HTMLElement) before.focus();
    return done;
  }
}
