/** The overview: whether people may enter, how far it is, and what can be taken away. */

import { button, element } from "../../shared/dom";
import { fill, said } from "../../shared/language";
import { report, table, type Person, type Progress, type State } from "../api";
import { askBefore } from "../dialog";
import type { Desk, View } from "../desk";
import { codeButton } from "./code";
import { copyButton } from "./copy";
import { downloadButton } from "./download";

export function overview(desk: Desk): View {
  const demo = element("p", { class: "note" }, desk.speech.words.demo_note);
  const figures = element("div", { class: "figures" });
  const state = element("section", { class: "card", "aria-labelledby": "state-title" });
  const registration = element("section", { class: "card", "aria-labelledby": "entry-title" });
  const node = element(
    "div",
    { class: "overview" },
    element("h2", { class: "sr-only" }, desk.speech.words.tabs.overview),
    demo,
    figures,
    element("div", { class: "pair" }, state, registration),
    results(desk),
  );
  let before = "";
  return {
    node,
    update(progress) {
      const counted = count(progress);
      const { people: _, ...rest } = progress;
      const now = JSON.stringify([rest, counted]);
      if (now === before) return;
      before = now;
      demo.hidden = progress.purpose !== "demo";
      const held = document.activeElement?.id ?? "";
      fillFigures(desk, figures, progress, counted);
      fillState(desk, state, progress);
      fillRegistration(desk, registration, progress);
      if (held !== "") document.getElementById(held)?.focus();
    },
  };
}

interface Count {
  entered: number;
  finished: number;
  flagged: number;
  excluded: number;
  /** The median time of those who have finished; null without any. */
  median_s: number | null;
}

/** People's figures and simulated observers', apart. */
function count({ people }: Progress): { people: Count; simulated: Count } {
  const of = (some: Person[]): Count => {
    const finished = some.filter((person) => person.finished);
    return {
      entered: some.length,
      finished: finished.length,
      flagged: some.filter((person) => person.flags.length > 0).length,
      excluded: some.filter((person) => person.excluded !== null).length,
      median_s: median(finished.flatMap((person) => person.seconds ?? [])),
    };
  };
  return {
    people: of(people.filter((person) => !person.simulated)),
    simulated: of(people.filter((person) => person.simulated)),
  };
}

function median(values: number[]): number | null {
  const sorted = [...values].sort((one, other) => one - other);
  const [low, high] = [sorted[(sorted.length - 1) >> 1], sorted[sorted.length >> 1]];
  return low === undefined || high === undefined ? null : (low + high) / 2;
}

function fillFigures(
  desk: Desk,
  node: HTMLElement,
  progress: Progress,
  { people, simulated }: { people: Count; simulated: Count },
): void {
  const { speech } = desk;
  const words = speech.words.figures;
  const figure = (name: string, value: string, beside = 0) =>
    element(
      "div",
      { class: "figure" },
      element(
        "dd",
        {},
        value,
        ...(beside > 0
          ? [element("small", {}, fill(words.simulated, { count: number(beside) }))]
          : []),
      ),
      element("dt", {}, name),
    );
  const number = (value: number) => value.toLocaleString(speech.language);
  const pair = (name: string, value: number, beside: number) => figure(name, number(value), beside);
  const shown = [
    pair(words.entered, people.entered, simulated.entered),
    pair(words.finished, people.finished, simulated.finished),
    pair(words.answers, progress.answers - progress.simulated, progress.simulated),
    figure(words.median, people.median_s === null ? words.none : speech.duration(people.median_s)),
    pair(words.flagged, people.flagged, simulated.flagged),
    pair(words.excluded, people.excluded, simulated.excluded),
  ];
  if (progress.erased > 0) shown.push(figure(words.erased, number(progress.erased)));
  node.replaceChildren(element("dl", {}, ...shown));
}

function fillState(desk: Desk, node: HTMLElement, progress: Progress): void {
  const words = desk.speech.words.state;
  const to = (state: State, label: string, main = false) =>
    button(label, () => void desk.act(() => desk.lab.setState(state)), {
      id: `to-${state}`,
      ...(main ? { class: "main" } : {}),
    });
  const closing = button(
    words.close,
    () => {
      void askBefore({
        title: words.close_title,
        note: words.close_note,
        act: words.close,
        cancel: desk.speech.words.people.cancel,
      }).then((given) => {
        if (given !== null) void desk.act(() => desk.lab.setState("closed"));
      });
    },
    { id: "to-closed" },
  );
  const open = progress.state === "open";
  const buttons = open ? [to("paused", words.pause)] : [to("open", words.reopen, true)];
  if (progress.state !== "closed") buttons.push(closing);
  node.replaceChildren(
    element("h3", { id: "state-title" }, words.title),
    element(
      "p",
      {},
      element("span", { class: `badge ${progress.state}` }, words[progress.state]),
      " ",
      words[`${progress.state}_note`],
    ),
    element("div", { class: "row" }, ...buttons),
  );
}

function fillRegistration(desk: Desk, node: HTMLElement, progress: Progress): void {
  const words = desk.speech.words.registration;
  const choice = (value: "open" | "invited") => {
    const input = element("input", {
      type: "radio",
      name: "registration",
      id: `registration-${value}`,
      checked: progress.registration === value,
    });
    input.addEventListener("change", () => {
      void desk.act(() => desk.lab.setRegistration(value));
    });
    return element("label", { class: "choice" }, input, words[value]);
  };
  const address = new URL("/", location.href).href;
  const note =
    progress.registration === "open"
      ? [
          element("p", { class: "soft" }, words.open_note),
          element(
            "p",
            { class: "row" },
            element("code", {}, address),
            copyButton(desk, address),
            codeButton(desk, address),
          ),
        ]
      : [element("p", { class: "soft" }, words.invited_note)];
  node.replaceChildren(
    element("h3", { id: "entry-title" }, words.title),
    element(
      "fieldset",
      { class: "plain" },
      element("legend", { class: "sr-only" }, words.title),
      choice("open"),
      choice("invited"),
    ),
    ...note,
  );
}

function results(desk: Desk): HTMLElement {
  const words = desk.speech.words.results;
  const reports = (simulated: boolean) =>
    desk.study.questions.map((question) =>
      element(
        "div",
        { class: "take" },
        element("span", {}, said(question.text, desk.speech.language)),
        ...(["en", "ja"] as const).map((language) => {
          const name = `report-${question.id}${simulated ? "-simulated" : ""}-${language}.html`;
          const from = () => report(question.id, language, simulated);
          return downloadButton(desk, words[`report_${language}`], from, name);
        }),
      ),
    );
  const bom = element("input", { type: "checkbox", id: "bom" });
  const csv = (which: "answers" | "people") => {
    const from = () => table(which, bom.checked);
    return downloadButton(desk, words[which], from, `${which}.csv`);
  };
  return element(
    "section",
    { class: "card", "aria-labelledby": "results-title" },
    element("h3", { id: "results-title" }, words.title),
    element("p", { class: "soft" }, words.lead),
    ...reports(false),
    element(
      "div",
      { class: "take" },
      element("span", { class: "soft" }, words.answers_note),
      csv("answers"),
      csv("people"),
    ),
    element("label", { class: "choice" }, bom, words.bom),
    element("h4", {}, words.simulated_title),
    element("p", { class: "soft" }, words.simulated_lead),
    ...reports(true),
  );
}
