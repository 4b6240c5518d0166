/** A quiet line at the foot of the page: that answers wait for the connection. */

import { element } from "../shared/dom";

export class Notice {
  readonly root = element("div", { class: "notice", role: "status" });

  show(words: string): void {
    if (this.root.textContent !== words) this.root.textContent = words;
  }

  hide(): void {
    this.root.textContent = "";
  }
}
