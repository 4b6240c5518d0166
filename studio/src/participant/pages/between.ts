/** Pages before and between the trials. */

import { element } from "../../shared/dom";
import { fill } from "../../shared/language";
import { progress } from "../progress";
import { reading } from "../sheet";
import type { Page } from "../stage";
import type { Words } from "../words/words";

type Next = "go" | "stop";

/** `text`: of the study, then of the task; `training`: how many trials of practice there are. */
export function instructionsPage(
  words: Words,
  text: readonly string[],
  training: number,
): Page<Next> {
  const practises = training > 0;
  const practice = fill(words.instructions_training, { n: training });
  const said = [...text, ...(practises ? [practice] : [])];
  const go = practises ? words.instructions_begin : words.begin;
  return reading("instructions", words.instructions_title, said, [["go", go]]);
}

export function trainingOverPage(words: Words, all: number): Page<Next> {
  const text = fill(words.training_over, { n: all });
  return reading("training-over", words.training_over_title, [text], [["go", words.begin]]);
}

export function resumedPage(words: Words, text: string): Page<Next> {
  return reading("resumed", words.resumed_title, [text], choices(words));
}

/** A break after `done` of `all` pairs; `asked`: the next question, where it is a new one. */
export function breakPage(
  words: Words,
  done: number,
  all: number,
  asked: string | null,
): Page<Next> {
  const text = [fill(words.break_text, { n: done, all })];
  if (asked !== null) text.push(`${words.break_next}:`, asked);
  const page = reading("break", words.break_title, text, choices(words));
  return {
    ...page,
    draw(into, left) {
      page.draw(into, left);
      const bar = progress(fill(words.pair_of, { n: done, all }), done / all);
      into.querySelector(".actions")?.before(element("div", { class: "so-far" }, bar));
    },
  };
}

export function stopPage(words: Words): Page<"back" | "later" | "withdraw"> {
  return reading(
    "stop",
    words.stop_title,
    [words.stop_text],
    [
      ["back", words.back],
      ["later", words.stop_later],
      ["withdraw", words.stop_withdraw],
    ],
  );
}

function choices(words: Words): [Next, string][] {
  return [
    ["go", words.go_on],
    ["stop", words.stop],
  ];
}
