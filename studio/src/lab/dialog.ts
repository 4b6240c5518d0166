/** A question before something is done. */

import { button, element } from "../shared/dom";

export interface Asking {
  title: string;
  note: string;
  /** The label of a reason to be typed. */
  reason?: string;
  act: string;
  cancel: string;
}

/** Ask; the reason that was typed ("" where none is asked for), or null if nothing is to be done. */
export function askBefore(asking: Asking): Promise<string | null> {
  const { title, note, reason, act, cancel } = asking;
  const given = element("input", { type: "text", id: "reason", required: true, maxlength: 1000 });
  const form = element(
    "form",
    { method: "dialog" },
    element("h2", { id: "dialog-title" }, title),
    element("p", {}, note),
  );
  if (reason !== undefined) {
    form.append(element("label", { for: "reason", class: "field" }, reason), given);
  }
  const dialog = element("dialog", { "aria-labelledby": "dialog-title" }, form);
  form.append(
    element(
      "div",
      { class: "row end" },
      button(cancel, () => dialog.close()),
      element("button", { type: "submit", class: "main", value: "act" }, act),
    ),
  );
  return new Promise((resolve) => {
    dialog.addEventListener("close", () => {
      resolve(dialog.returnValue === "act" ? given.value.trim() : null);
      dialog.remove();
    });
    form.addEventListener("submit", (event) => {
      if (reason !== undefined && given.value.trim() === "") event.preventDefault();
    });
    document.body.append(dialog);
    dialog.showModal();
    if (reason !== undefined) given.focus();
  });
}
