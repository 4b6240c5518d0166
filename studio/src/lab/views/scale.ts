/** The scale so far, people's and simulated ones' apart. */

import { element } from "../../shared/dom";
import { Problem } from "../../shared/http";
import { apart, fill, said } from "../../shared/language";
import type { Scale } from "../api";
import type { Desk, View } from "../desk";
import { chart, numeral } from "./chart";
import { boxed, head, row } from "./table";

export function scale(desk: Desk): View {
  const { words } = desk.speech;
  const shown = element("div", { class: "card", "aria-live": "off" });
  const drawn = new Drawing(desk, shown);
  let wanted = "";
  let before = "";
  const show = (found: Scale | { problem: string }) => {
    const now = wanted + JSON.stringify(found);
    if (now !== before) drawn.show(found);
    before = now;
  };
  // Asked each time, though nothing has changed: what the server tells may be of a moment ago.
  const look = async () => {
    const { question, simulated } = desk.kept;
    const asked = (wanted = JSON.stringify([question, simulated]));
    try {
      const found = await desk.lab.scale(question, simulated);
      if (asked === wanted) show(found);
    } catch (problem) {
      if (!(problem instanceof Problem && problem.status === 400)) throw problem;
      if (asked === wanted) show({ problem: problem.message });
    }
  };
  const changed = () => void desk.act(look);
  const node = element(
    "div",
    {},
    element(
      "div",
      { class: "row heading" },
      element("h2", {}, words.scale.title),
      ...choices(desk, changed),
    ),
    shown,
  );
  return {
    node,
    update: look,
  };
}

function choices(desk: Desk, changed: () => void): HTMLElement[] {
  const { kept } = desk;
  const { questions } = desk.study;
  const words = desk.speech.words.scale;
  const question = element(
    "select",
    { id: "question" },
    ...questions.map((one) =>
      element("option", { value: one.id }, said(one.text, desk.speech.language)),
    ),
  );
  question.value = kept.question;
  question.addEventListener("change", () => {
    kept.question = question.value;
    changed();
  });
  const whose = [false, true].map((simulated) => {
    const input = element("input", {
      type: "radio",
      name: "whose",
      id: simulated ? "whose-simulated" : "whose-people",
      checked: kept.simulated === simulated,
    });
    input.addEventListener("change", () => {
      kept.simulated = simulated;
      changed();
    });
    return element("label", { class: "tab" }, input, simulated ? words.simulated : words.people);
  });
  const group = element(
    "fieldset",
    { class: "plain tabs" },
    element("legend", { class: "sr-only" }, words.whose),
    ...whose,
  );
  if (questions.length < 2) return [group];
  return [element("label", { class: "inline" }, words.question, question), group];
}

/** What was found, drawn anew when the window's width changes. */
class Drawing {
  private found: Scale | null = null;
  private readonly place = element("div", { class: "drawing" });

  constructor(
    private readonly desk: Desk,
    private readonly node: HTMLElement,
  ) {
    new ResizeObserver(() => this.draw()).observe(this.place);
  }

  show(found: Scale | { problem: string }): void {
    const words = this.desk.speech.words.scale;
    if ("problem" in found) {
      this.found = null;
      this.node.replaceChildren(
        element("p", { class: "empty" }, words.none),
        ...why(found.problem, words).map((said) => element("p", {}, said)),
        element("p", { class: "soft" }, fill(words.reason, { problem: found.problem })),
      );
      return;
    }
    this.found = found;
    const { simulated } = this.desk.kept;
    const from = simulated ? words.from_simulated : words.from;
    this.node.replaceChildren(
      element("h3", {}, said(found.text, this.desk.speech.language)),
      ...(simulated ? [element("p", { class: "note" }, words.simulated_note)] : []),
      ...(found.people_differ ? [element("p", { class: "note" }, words.people_differ)] : []),
      this.place,
      element(
        "p",
        { class: "soft" },
        fill(from, { answers: found.answers, people: found.people }),
        " ",
        fill(words.interval, { level: 100 * found.level }),
      ),
      ...(found.stimuli.some((one) => one.low === null || one.high === null)
        ? [element("p", {}, words.unset_note)]
        : []),
      element("p", {}, verdict(found, words)),
      table(found, words),
    );
    this.draw();
  }

  private draw(): void {
    const width = Math.floor(this.place.clientWidth);
    if (this.found === null || width < 100) return;
    const before = this.place.querySelector("svg");
    const words = this.desk.speech.words.scale;
    const labels = this.found.stimuli.map((one) => apart(one.label)).join(", ");
    const drawn = chart(this.found, width, {
      alt: fill(words.chart, { labels }),
      axis: fill(words.axis, { unit: this.found.unit }),
      mark: this.desk.kept.simulated ? words.simulated_mark : "",
    });
    if (before?.outerHTML !== drawn.outerHTML) this.place.replaceChildren(drawn);
  }
}

/** In our own words why there is no scale, where the server's reason is one that is known. */
function why(problem: string, words: ScaleWords): string[] {
  if (problem.startsWith("no answers")) return [words.none_answers];
  if (problem.startsWith("no scale holds")) return [words.always];
  return problem.startsWith("no scale joins") ? [words.apart] : [];
}

type ScaleWords = Desk["speech"]["words"]["scale"];

function verdict(found: Scale, words: ScaleWords): string {
  if (found.verdict === "misfits" && found.misfit) {
    const [first, second] = found.misfit;
    return fill(words.misfits_pair, { first, second });
  }
  if (found.verdict === "misfits") return words.misfits;
  if (found.verdict === "untested") return words.untested;
  if (found.people_differ) return words.describes_sums;
  return found.people_told ? words.describes : words.describes_untold;
}

function table(found: Scale, words: ScaleWords): HTMLElement {
  const heads = [words.stimulus, words.value, words.low, words.high];
  const rows = found.stimuli.map((one) =>
    row(heads, [
      element("th", { scope: "row" }, one.label),
      ...[one.value, one.low, one.high].map((value) =>
        element("td", {}, value === null ? words.unset : numeral(value)),
      ),
    ]),
  );
  const body = element("tbody", { role: "rowgroup" }, ...rows);
  return element(
    "details",
    {},
    element("summary", {}, words.table),
    boxed(words.table, element("table", { class: "numbers" }, head(heads), body)),
  );
}
