/** Where a sitting goes on. */

import type { Answer } from "../api";

interface Resumption {
  /** The first trial without an answer. */
  next: number;
  /** Answers that only the browser has, in order. */
  unsent: Answer[];
}

/**
 * Go on after the last answer that the server or this browser has.
 *
 * The server has the trials before `answered`. Of the browser's log counts what follows on without a
 * gap: the server takes no answer before its turn.
 */
export function resume(answered: number, kept: readonly Answer[]): Resumption {
  const byTrial = new Map(kept.map((answer) => [answer.trial, answer]));
  const unsent: Answer[] = [];
  for (let answer = byTrial.get(answered); answer; answer = byTrial.get(answered + unsent.length)) {
    unsent.push(answer);
  }
  return { next: answered + unsent.length, unsent };
}
