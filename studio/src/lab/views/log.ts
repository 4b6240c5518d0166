/** The audit log. */

import { element } from "../../shared/dom";
import type { Event } from "../api";
import type { Desk, View } from "../desk";
import { boxed, head, row } from "./table";

export function log(desk: Desk): View {
  const words = desk.speech.words.log;
  const list = element("div");
  let sign = "";
  const node = element(
    "div",
    {},
    element("h2", {}, words.title),
    element("p", { class: "soft" }, words.lead),
    list,
  );
  return {
    node,
    async update() {
      const events = await desk.lab.events();
      const now = JSON.stringify(events);
      if (now === sign) return;
      sign = now;
      list.replaceChildren(
        events.length === 0 ? element("p", {}, words.none) : table(desk, events),
      );
    },
  };
}

function table(desk: Desk, events: Event[]): HTMLElement {
  const { speech } = desk;
  const words = speech.words.log;
  const heads = [words.at, words.who, words.what, words.person, words.detail];
  const rows = [...events]
    .reverse()
    .map((event) =>
      row(heads, [
        element("td", { class: "nowrap" }, speech.moment(event.at)),
        element("td", { class: "nowrap" }, words.people[event.who] ?? event.who),
        element("td", {}, words.events[event.what] ?? event.what),
        element("td", {}, event.number === null ? "" : String(event.number)),
        element("td", { class: "detail" }, detail(event.detail)),
      ]),
    );
  const body = element("tbody", { role: "rowgroup" }, ...rows);
  return boxed(words.title, element("table", { class: "log" }, head(heads), body));
}

function detail(given: Record<string, unknown>): string {
  return Object.entries(given)
    .map(([name, value]) => `${name}: ${typeof value === "string" ? value : JSON.stringify(value)}`)
    .join("; ");
}
