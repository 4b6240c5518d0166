/** A button that brings a file, and says so while it is made. */

import { button, element } from "../../shared/dom";
import { bring } from "../../shared/http";
import type { File } from "../api";
import type { Desk } from "../desk";

/** A report draws a thousand samples and takes its time. */
const PATIENCE_MS = 180_000;

export function downloadButton(desk: Desk, label: string, from: () => File, name: string) {
  const made = button(label, () => {
    made.setAttribute("aria-busy", "true");
    made.disabled = true;
    made.textContent = desk.speech.words.results.making;
    void desk
      .act(async () => save(await fetched(from()), name))
      .finally(() => {
        made.removeAttribute("aria-busy");
        made.disabled = false;
        made.textContent = label;
      });
  });
  made.classList.add("small");
  return made;
}

function fetched({ route, query }: File): Promise<Blob> {
  return bring(route, { query, patience_ms: PATIENCE_MS });
}

function save(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  const link = element("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  // The browser has taken hold of it by then.
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
