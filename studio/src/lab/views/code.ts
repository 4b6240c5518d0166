/** A link as a QR code, for a tablet or a phone that is held before the screen. */

import { encode } from "uqr";

import { button, element } from "../../shared/dom";
import type { Desk } from "../desk";

const NS = "http://www.w3.org/2000/svg";
/** Modules of quiet around a code, as ISO/IEC 18004 wants them. */
const QUIET = 4;

/** A text as a QR code: dark modules on white. */
export function code(text: string, alt: string): SVGElement {
  const { data, size } = encode(text, { ecc: "M", border: 0 });
  const dark = data.flatMap((row, y) =>
    row.flatMap((isDark, x) => (isDark ? [`M${x + QUIET} ${y + QUIET}h1v1h-1z`] : [])),
  );
  const all = size + 2 * QUIET;
  const drawn = document.createElementNS(NS, "svg");
  drawn.setAttribute("class", "code");
  drawn.setAttribute("role", "img");
  drawn.setAttribute("aria-label", alt);
  drawn.setAttribute("viewBox", `0 0 ${all} ${all}`);
  const path = document.createElementNS(NS, "path");
  path.setAttribute("d", dark.join(""));
  drawn.append(path);
  return drawn;
}

/** A button that shows a link as a code. */
export function codeButton(desk: Desk, link: string): HTMLButtonElement {
  const words = desk.speech.words.invitations;
  return button(
    words.code,
    () => {
      const dialog = element("dialog", { "aria-label": words.code_of, class: "showing" });
      dialog.append(
        code(link, words.code_of),
        element("p", {}, element("code", {}, link)),
        element(
          "div",
          { class: "row end" },
          button(words.close, () => dialog.close(), { class: "main" }),
        ),
      );
      dialog.addEventListener("close", () => dialog.remove());
      document.body.append(dialog);
      dialog.showModal();
    },
    { class: "small" },
  );
}
