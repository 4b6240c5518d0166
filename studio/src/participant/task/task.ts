/** What a task is to a sitting: a way to show a trial and to answer it, played by jsPsych. */

import type { Language } from "../../shared/language";
import type { Answer, Picture, Study, Trial } from "../api";
import type { Pictures } from "../pictures";
import type { Scale } from "../sizes";
import type { Words } from "../words/words";

/** What all trials of a sitting share. */
export interface Setting {
  study: Study;
  words: Words;
  language: Language;
  /** What is known of the screen. */
  scale: Scale;
  /** Every picture of the sitting, by name: how large it is. */
  pictures: Record<string, Picture>;
  fetched: Pictures;
  /** Keeps an answer; the next trial waits for it. */
  keep: (answer: Answer) => Promise<void>;
}

/** How far a trial is among those of its kind, from 1. */
export interface Place {
  n: number;
  all: number;
}

export interface Task {
  /** A trial as jsPsych plays it, of the class trial-page; simulations are its plugin's. */
  trial(setting: Setting, trial: Trial, place: Place): object;
  /** What instructions say of how one answers, after the study's own words. */
  instructions(words: Words, rules: Study["sitting"]): string[];
}
