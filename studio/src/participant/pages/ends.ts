/** Pages that a sitting ends with, or cannot begin with: each says what can be done. */

import { Problem } from "../../shared/http";
import { reading } from "../sheet";
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
  const action = ACTIONS[end];
  const actions: ("again" | "next")[] = [];
  if (action !== undefined) actions.push("again");
  if (next) actions.push("next");
  const page = reading(
    end,
    words[`${end}_title`],
    [words[end]],
    actions.map((result) => [result, result === "next" ? words.thanks_next : words[action!]]),
  );
  return { ...page, play: () => undefined };
}

/** What a refusal of the server means to a participant. */
export function endOf(problem: Problem): End {
  if (problem.kind === "token") return "unknown";
  if (problem.kind === "not-allowed") return "stopped";
  return "broken";
}
