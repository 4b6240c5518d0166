/** Tables that a telephone can show: each row then stands as a card, each cell under its heading. */

import { element } from "../../shared/dom";

/** The head of a table. */
export function head(names: readonly string[]): HTMLTableSectionElement {
  const cells = names.map((name) => element("th", { scope: "col", role: "columnheader" }, name));
  return element("thead", { role: "rowgroup" }, element("tr", { role: "row" }, ...cells));
}

/** A row whose cells bear the names of their columns, for where the head is out of sight. */
export function row(
  names: readonly string[],
  cells: readonly HTMLTableCellElement[],
  attributes: Record<string, string> = {},
): HTMLTableRowElement {
  cells.forEach((cell, place) => {
    cell.dataset["column"] = names[place] ?? "";
    cell.setAttribute("role", cell.tagName === "TH" ? "rowheader" : "cell");
  });
  return element("tr", { role: "row", ...attributes }, ...cells);
}

/** A table in a box of its own, which scrolls where it must. */
export function boxed(title: string, table: HTMLTableElement): HTMLElement {
  table.setAttribute("role", "table"); // told still where it is laid out as cards
  return element(
    "div",
    { class: "scroll", role: "region", "aria-label": title, tabindex: 0 },
    table,
  );
}
