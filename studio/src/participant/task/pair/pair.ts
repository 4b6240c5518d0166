/** A pair as a task: two pictures, one question, and what is said around them. */

import "./pair.css";
import { fill, said } from "../../../shared/language";
import type { Trial } from "../../api";
import { mayHaveKeys } from "../../keyboard";
import { drawn, pxPerMm, shrinkage } from "../../sizes";
import type { Room } from "../../sizes";
import type { Place, Setting, Task } from "../task";
import { PairPlugin } from "./plugin";
import type { Pair } from "./plugin";
import type { PairWords, Sizes } from "./view";

export const pair: Task = {
  trial: (setting, trial, place) => ({
    type: PairPlugin,
    css_classes: ["trial-page", "pair-page"],
    ...shown(setting, trial, place),
  }),
  instructions(words, rules) {
    const keys = mayHaveKeys();
    const tie = keys ? words.instructions_ties : fill(words.instructions_touch_ties, words);
    return [
      keys ? words.instructions_keys : words.instructions_touch,
      ...(rules.ties ? [tie] : []),
    ];
  },
};

function shown(setting: Setting, trial: Trial, place: Place): Pair {
  const { study, fetched } = setting;
  return {
    trial: trial.trial,
    words: wordsOf(setting, trial, place),
    share: (place.n - 1) / place.all,
    minimum_viewing_ms: study.sitting.minimum_viewing_ms,
    ties: study.sitting.ties,
    images: () => Promise.all([fetched.decoded(trial.left), fetched.decoded(trial.right)]),
    sizes: (room) => sizes(setting, trial, room),
    keep: setting.keep,
  };
}

function wordsOf({ study, words, language }: Setting, trial: Trial, place: Place): PairWords {
  const asked = study.questions.find(({ id }) => id === trial.question);
  const progress = trial.training ? words.training_of : words.pair_of;
  return {
    question: asked === undefined ? "" : said(asked.text, language),
    left: words.left_picture,
    right: words.right_picture,
    tie: words.tie,
    progress: fill(progress, { n: place.n, all: place.all }),
    early: words.pair_early,
    keys: !mayHaveKeys() ? "" : study.sitting.ties ? words.pair_keys_tie : words.pair_keys,
  };
}

function sizes({ scale, pictures }: Setting, trial: Trial, room: Room): Sizes {
  const px_per_mm = pxPerMm(scale, devicePixelRatio);
  const shrunk = shrinkage(Object.values(pictures), px_per_mm, room);
  const size = (name: string): Room => {
    const picture = pictures[name];
    return picture ? drawn(picture, px_per_mm, shrunk) : { width_px: 0, height_px: 0 };
  };
  return { left: size(trial.left), right: size(trial.right), shrunk };
}
