/** One person as a row of the table, and the row that explains their flags. */

import { button, element } from "../../shared/dom";
import { fill } from "../../shared/language";
import type { Flag, Person } from "../api";
import { askBefore } from "../dialog";
import type { Desk } from "../desk";
import { row } from "./table";

/** The names of the columns. */
export function columns({ speech }: Desk): string[] {
  const words = speech.words.people;
  const { number, group, answers, seen, time, flags } = words;
  return [number, group, answers, seen, time, flags, words.actions];
}

export function rowOf(
  desk: Desk,
  person: Person,
  open: boolean,
  again: () => void,
): HTMLTableRowElement {
  const { speech } = desk;
  const words = speech.words.people;
  const classes = [
    person.excluded === null ? "" : "excluded",
    person.simulated ? "simulated" : "",
    person.erased ? "erased" : "",
  ].filter((one) => one !== "");
  const cells = [
    element("th", { scope: "row" }, String(person.number)),
    element("td", {}, ...marks(desk, person)),
    element("td", {}, ...answered(desk, person)),
    element(
      "td",
      { class: "nowrap" },
      person.last_at === null
        ? speech.words.figures.none
        : element("time", { datetime: person.last_at, title: speech.moment(person.last_at) }),
    ),
    element(
      "td",
      { class: "nowrap" },
      person.seconds === null ? speech.words.figures.none : speech.duration(person.seconds),
    ),
    element("td", {}, flagButton(desk, person, open, again)),
    element(
      "td",
      { class: "actions" },
      ...(person.erased ? [words.erased] : actions(desk, person)),
    ),
  ];
  return row(columns(desk), cells, { class: classes.join(" ") });
}

/** Whether somebody is left out at their own wish, which no experimenter takes back. */
function withdrew(person: Person): boolean {
  return person.excluded === "withdrew";
}

function marks(desk: Desk, person: Person): (Node | string)[] {
  const words = desk.speech.words.people;
  const groups = Object.entries(person.groups);
  const named = groups.map(([name, value]) => (groups.length > 1 ? `${name}: ${value}` : value));
  const shown: (Node | string)[] = [named.join(", "), " "];
  if (person.simulated) shown.push(element("span", { class: "badge simulated" }, words.simulated));
  if (person.excluded !== null) {
    const reason = withdrew(person)
      ? words.withdrew
      : fill(words.excluded_because, { reason: person.excluded });
    shown.push(element("span", { class: "badge excluded" }, reason));
  }
  return shown;
}

function answered(desk: Desk, person: Person): Node[] {
  const words = desk.speech.words.people;
  const share = person.trials === 0 ? 0 : Math.min(1, person.answers / person.trials);
  const full = element("span", { class: person.finished ? "full finished" : "full" });
  full.style.inlineSize = `${100 * share}%`;
  const text = fill(words.of, { answers: person.answers, trials: person.trials });
  const done = person.finished ? element("span", { class: "sr-only" }, words.finished) : "";
  const bar = element("span", { class: "bar", "aria-hidden": "true" }, full);
  const count = element("span", { class: "count" }, text, done);
  return [element("div", { class: "answered" }, bar, count)];
}

function flagButton(desk: Desk, person: Person, open: boolean, again: () => void): Node | string {
  if (person.flags.length === 0) return "";
  const chips = person.flags.map((flag) =>
    element("span", { class: "chip" }, told(desk, flag).name),
  );
  const made = button(
    "",
    () => {
      const { explained } = desk.kept;
      if (!explained.delete(person.number)) explained.add(person.number);
      again();
    },
    { id: `flags-of-${person.number}`, class: "chips", "aria-expanded": String(open) },
  );
  made.append(...chips);
  return made;
}

/** What each flag of a person means. */
export function explanation(desk: Desk, person: Person): HTMLTableRowElement {
  const words = desk.speech.words.people;
  const items = person.flags.map((flag) => {
    const { name, why } = told(desk, flag);
    return element("li", {}, element("b", {}, name), " ", why);
  });
  const label = fill(words.flags_of, { number: person.number });
  const list = element("ul", { "aria-label": label }, ...items);
  return row([label], [element("td", { colspan: 7 }, list)], { class: "why" });
}

function told(desk: Desk, flag: Flag): { name: string; why: string } {
  const words = desk.speech.words;
  const [family = "", ...rest] = flag.kind.split("-");
  const known: Record<string, { name: string; why: string } | undefined> = words.flags;
  const found = known[flag.kind] ?? known[family];
  if (found === undefined) return { name: flag.kind, why: flag.detail };
  const inside = rest.join("-");
  const what = words.noticed[inside] ?? inside;
  return {
    name: fill(found.name, { what }),
    why: fill(found.why, { what, detail: detail(desk, flag) }),
  };
}

/** "2/3" as 2 of 3, "640 s" as a duration. */
function detail(desk: Desk, flag: Flag): string {
  const seconds = /^(\d+) s$/.exec(flag.detail);
  if (seconds !== null) return desk.speech.duration(Number(seconds[1]));
  const share = /^(.+)\/(.+)$/.exec(flag.detail);
  if (share === null) return flag.detail;
  const [, answers = "", trials = ""] = share;
  return fill(desk.speech.words.people.of, { answers, trials });
}

function actions(desk: Desk, person: Person): Node[] {
  const { number } = person;
  const { people: words } = desk.speech.words;
  const { cancel, reason } = words;
  const small = (id: string) => ({ id: `${id}-${number}`, class: "small", "aria-label": "" });
  const named = (made: HTMLButtonElement) => {
    made.setAttribute("aria-label", `${made.textContent} ${words.number} ${number}`);
    return made;
  };
  const exclude = () =>
    void askBefore({
      title: fill(words.exclude_title, { number }),
      note: words.exclude_note,
      reason,
      act: words.exclude_short,
      cancel,
    }).then((given) => {
      if (given !== null) void desk.act(() => desk.lab.exclude(number, given));
    });
  const revoke = () =>
    void askBefore({
      title: fill(words.revoke_title, { number }),
      note: words.revoke_note,
      act: words.revoke_short,
      cancel,
    }).then((given) => {
      if (given !== null) void desk.act(() => desk.lab.revoke(number));
    });
  const first =
    person.excluded === null
      ? button(words.exclude, exclude, small("exclude"))
      : button(
          words.readmit,
          () => void desk.act(() => desk.lab.readmit(number)),
          small("readmit"),
        );
  const own = withdrew(person) ? [] : [named(first)];
  return [...own, named(button(words.revoke, revoke, small("revoke")))];
}
