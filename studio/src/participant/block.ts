/** Trials that follow each other without a break. */

import { fill, said } from "../shared/language";
import type { Language } from "../shared/language";
import type { Answer, Picture, SittingTold, Study, Trial } from "./api";
import { PairPlugin } from "./pair";
import type { Pair } from "./pair";
import type { PairWords, Sizes } from "./pair-view";
import type { Pictures } from "./pictures";
import { drawn, pxPerMm, shrinkage } from "./sizes";
import type { Room, Scale } from "./sizes";
import type { Words } from "./words/words";

/** Trials from `next` on, parted where there is a break and where the training ends. */
export function blocksOf(trials: readonly Trial[], next: number): Trial[][] {
  const blocks: Trial[][] = [];
  for (const trial of trials.slice(next)) {
    const block = blocks.at(-1);
    const before = block?.at(-1);
    const joined =
      before !== undefined && !trial.break_before && before.training === trial.training;
    if (joined) block?.push(trial);
    else blocks.push([trial]);
  }
  return blocks;
}

/** How far a trial is among those of its kind: training, or those that count. */
export function placeOf(trials: readonly Trial[], trial: Trial): { n: number; all: number } {
  const alike = trials.filter(({ training }) => training === trial.training);
  return { n: alike.findIndex((one) => one.trial === trial.trial) + 1, all: alike.length };
}

/** Turns trials into what jsPsych plays. */
export class Presenter {
  private readonly pictures: readonly Picture[];

  constructor(
    private readonly study: Study,
    private readonly sitting: SittingTold,
    private readonly words: Words,
    private readonly language: Language,
    private readonly scale: Scale,
    private readonly fetched: Pictures,
    private readonly keep: (answer: Answer) => Promise<void>,
  ) {
    this.pictures = Object.values(sitting.pictures);
  }

  timeline(block: readonly Trial[]): object[] {
    return block.map((trial) => ({
      type: PairPlugin,
      css_classes: ["pair-page"],
      ...this.pair(trial),
    }));
  }

  private pair(trial: Trial): Pair {
    const { n, all } = placeOf(this.sitting.trials, trial);
    return {
      trial: trial.trial,
      words: this.said(trial, n, all),
      share: (n - 1) / all,
      minimum_viewing_ms: this.study.sitting.minimum_viewing_ms,
      ties: this.study.sitting.ties,
      images: () =>
        Promise.all([this.fetched.decoded(trial.left), this.fetched.decoded(trial.right)]),
      sizes: (room) => this.sizes(trial, room),
      keep: this.keep,
    };
  }

  private said(trial: Trial, n: number, all: number): PairWords {
    const { words } = this;
    const asked = this.study.questions.find(({ id }) => id === trial.question);
    return {
      question: asked === undefined ? "" : said(asked.text, this.language),
      left: words.left_picture,
      right: words.right_picture,
      tie: words.tie,
      progress: fill(trial.training ? words.training_of : words.pair_of, { n, all }),
      early: words.pair_early,
      keys: this.keys(),
    };
  }

  /** What keys there are, where there may be a keyboard. */
  private keys(): string {
    if (!matchMedia("(any-hover: hover)").matches) return "";
    return this.study.sitting.ties ? this.words.pair_keys_tie : this.words.pair_keys;
  }

  private sizes(trial: Trial, room: Room): Sizes {
    const px_per_mm = pxPerMm(this.scale, devicePixelRatio);
    const shrunk = shrinkage(this.pictures, px_per_mm, room);
    const size = (name: string): Room => {
      const picture = this.sitting.pictures[name];
      return picture ? drawn(picture, px_per_mm, shrunk) : { width_px: 0, height_px: 0 };
    };
    return { left: size(trial.left), right: size(trial.right), shrunk };
  }
}
