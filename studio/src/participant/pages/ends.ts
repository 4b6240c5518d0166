/** Pages that a sitting ends with, or cannot begin with: each says what can be done. */

import { button, element } from "../../shared/dom";
import type { Problem } from "../../shared/http";
import type { Ending } from "../api";
import { sheet } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

export type End =
  | "declined"
  | "later"
  | "withdrawn"
  | "thanks"
  | "refused"
  | "paused"
  | "closed"
  | "invited"
  | "unknown"
  | "stopped"
  | "tabs"
  | "broken";

/** A reason to leave the way through the study. */
export class Ended extends Error {
  constructor(
    readonly end: End,
    readonly ending: Ending | null = null,
  ) {
    super(end);
  }
}

/** What can be done at an end, where something can. */
const ACTIONS: Partial<Record<End, keyof Words>> = {
  declined: "back",
  later: "go_on",
  paused: "try_again",
  refused: "refused_again",
  tabs: "try_again",
  broken: "try_again",
};

/** An end; `next`: whether another person may begin in this browser. A simulation stays at it. */
export function endPage(
  words: Words,
  end: End,
  next = false,
  ending: Ending | null = null,
): Page<"again" | "next"> {
  return {
    name: end,
    draw(into, done) {
      const action = ACTIONS[end];
      const actions: HTMLElement[] = [];
      if (ending?.return_url != null) actions.push(wayBack(words, ending.return_url));
      if (action !== undefined) {
        actions.push(button(words[action], () => done("again"), { class: "main" }));
      }
      if (next) actions.push(button(words.thanks_next, () => done("next")));
      sheet(into, words[`${end}_title`], said(words, end, ending), actions);
    },
  };
}

/** What an end says; to who has finished also the code, and what it is for. */
function said(words: Words, end: End, ending: Ending | null): HTMLElement[] {
  if (!pays(ending)) return [element("p", {}, words[end])];
  const lines = [element("p", {}, words.thanks_stored)];
  if (ending.return_url !== null) lines.push(element("p", {}, words.thanks_return_use));
  if (ending.code !== null) {
    const code = element("code", { class: "completion", translate: "no" }, ending.code);
    const use = ending.return_url === null ? words.thanks_code : words.thanks_code_too;
    lines.push(element("p", {}, use), element("p", {}, code));
  }
  return lines;
}

/** Whether somebody who has finished is given anything. */
export function pays(ending: Ending | null): ending is Ending {
  return ending !== null && (ending.code !== null || ending.return_url !== null);
}

function wayBack(words: Words, address: string): HTMLElement {
  return element(
    "a",
    { class: "button main", href: address, rel: "noreferrer" },
    words.thanks_return,
  );
}

/** What a refusal of the server means to a participant. */
export function endOf(problem: Problem): End {
  if (problem.kind === "token") return "unknown";
  if (problem.kind === "not-allowed") return "stopped";
  return "broken";
}
