/** Trials that follow each other without a break. */

import type { Trial } from "./api";
import type { Place, Setting } from "./task/task";
import { taskOf } from "./task/tasks";

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
export function placeOf(trials: readonly Trial[], trial: Trial): Place {
  const alike = trials.filter(({ training }) => training === trial.training);
  return { n: alike.findIndex((one) => one.trial === trial.trial) + 1, all: alike.length };
}

/** Turns trials into what jsPsych plays. */
export class Presenter {
  constructor(
    private readonly trials: readonly Trial[],
    private readonly setting: Setting,
  ) {}

  timeline(block: readonly Trial[]): object[] {
    return block.map((trial) =>
      taskOf(trial).trial(this.setting, trial, placeOf(this.trials, trial)),
    );
  }
}
