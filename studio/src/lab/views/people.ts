/** The people: how far each is, what to look at, and what can be done about it. */

import { element } from "../../shared/dom";
import { fill } from "../../shared/language";
import type { Person, Progress } from "../api";
import type { Desk, Kept, View } from "../desk";
import { columns, explanation, rowOf } from "./person";
import { boxed, head } from "./table";

const CHOICES = ["everyone", "people", "simulated", "flagged"] as const;

export function people(desk: Desk): View {
  const words = desk.speech.words.people;
  const choice = element("select", { id: "shown" });
  const body = element("tbody", { role: "rowgroup" });
  const empty = element("p", { class: "soft" }, words.none);
  const table = element("table", { class: "people" }, head(columns(desk)), body);
  const scroll = boxed(words.title, table);
  const note = element("p", { class: "soft" });
  const node = element(
    "div",
    {},
    element(
      "div",
      { class: "row heading" },
      element("h2", {}, words.title),
      element("label", { class: "inline" }, words.show, choice),
    ),
    empty,
    scroll,
    note,
  );
  let last: Progress | null = null;
  const rows = new Rows(body, desk, () => last !== null && show(last));
  const show = (progress: Progress) => {
    last = progress;
    fillChoice(desk, choice, progress.people);
    const shown = progress.people.filter((person) => isShown(person, desk.kept.shown));
    empty.hidden = progress.people.length > 0;
    scroll.hidden = progress.people.length === 0;
    note.textContent = progress.flags_known ? words.flags_note : words.flags_coming;
    rows.show(shown);
  };
  choice.addEventListener("change", () => {
    desk.kept.shown = CHOICES.find((one) => one === choice.value) ?? "everyone";
    if (last !== null) show(last);
  });
  return { node, update: show };
}

function isShown(person: Person, shown: Kept["shown"]): boolean {
  if (shown === "people") return !person.simulated;
  if (shown === "simulated") return person.simulated;
  return shown === "everyone" || person.flags.length > 0;
}

function fillChoice(desk: Desk, choice: HTMLSelectElement, everyone: Person[]): void {
  const words = desk.speech.words.people;
  const names = {
    everyone: words.everyone,
    people: words.only_people,
    simulated: words.only_simulated,
    flagged: words.only_flagged,
  };
  CHOICES.forEach((one, place) => {
    const count = everyone.filter((person) => isShown(person, one)).length;
    const option = choice.options[place] ?? element("option", { value: one });
    option.textContent = fill(names[one], { count });
    if (choice.options[place] === undefined) choice.append(option);
  });
  choice.value = desk.kept.shown;
}

/** The rows of the table. One that has not changed stays, and with it the keyboard's place. */
class Rows {
  private readonly made = new Map<string, { sign: string; row: HTMLTableRowElement }>();

  constructor(
    private readonly body: HTMLTableSectionElement,
    private readonly desk: Desk,
    private readonly again: () => void,
  ) {}

  show(shown: Person[]): void {
    const held = document.activeElement?.id ?? "";
    const wanted: HTMLTableRowElement[] = [];
    for (const person of shown) {
      const open = this.desk.kept.explained.has(person.number) && person.flags.length > 0;
      wanted.push(
        this.row(`person-${person.number}`, [person, open], () =>
          rowOf(this.desk, person, open, this.again),
        ),
      );
      if (open) {
        wanted.push(
          this.row(`flags-${person.number}`, person.flags, () => explanation(this.desk, person)),
        );
      }
    }
    const same =
      wanted.length === this.body.rows.length &&
      wanted.every((row, place) => row === this.body.rows[place]);
    if (!same) this.body.replaceChildren(...wanted);
    const now = new Date();
    for (const cell of this.body.querySelectorAll<HTMLElement>("time[datetime]")) {
      cell.textContent = this.desk.speech.ago(cell.getAttribute("datetime") ?? "", now);
    }
    if (held !== "" && document.activeElement?.id !== held) document.getElementById(held)?.focus();
  }

  private row(key: string, of: unknown, make: () => HTMLTableRowElement): HTMLTableRowElement {
    const sign = JSON.stringify(of);
    const kept = this.made.get(key);
    if (kept?.sign === sign) return kept.row;
    const row = make();
    this.made.set(key, { sign, row });
    return row;
  }
}
