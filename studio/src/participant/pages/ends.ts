/** Pages that a sitting ends with, or cannot begin with: each says what can be done. */

import { button, element } from "../../shared/dom";
import type { Problem } from "../../shared/http";
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
  constructor(readonly end: End) {
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
export function endPage(words: Words, end: End, next = false): Page<"again" | "next"> {
  return {
    name: end,
    draw(into, done) {
      const action = ACTIONS[end];
      const actions: HTMLElement[] = [];
      if (action !== undefined) {
        actions.push(button(words[action], () => done("again"), { class: "main" }));
      }
      if (next) actions.push(button(words.thanks_next, () => done("next")));
      sheet(into, words[`${end}_title`], [element("p", {}, words[end])], actions);
    },
  };
}

/** What a refusal of the server means to a participant. */
export function endOf(problem: Problem): End {
  if (problem.kind === "token") return "unknown";
  if (problem.kind === "not-allowed") return "stopped";
  return "broken";
}
