/** jsPsych's plugin for a pair: a cross, two pictures in one frame, and the answer to one question. */

import { ParameterType } from "jspsych";
import type { JsPsych, JsPsychPlugin, TrialType } from "jspsych";
import type { Answer, Chosen } from "../../api";
import type { Room } from "../../sizes";
import type { Simulation } from "../../stage";
import { Watch } from "../../watch";
import { PairView } from "./view";
import type { PairWords, Sizes } from "./view";

const CROSS_MS = 500;
/** A day: the longest time that is kept. A page left open for longer has measured none. */
const LONGEST_MS = 86_400_000;

const info = {
  name: "nacreous-pair",
  version: "1.0.0",
  parameters: {
    /** The trial's number in the sitting. */
    trial: { type: ParameterType.INT, default: undefined },
    words: { type: ParameterType.OBJECT, default: undefined },
    /** How much of the sitting is done, 0 to 1. */
    share: { type: ParameterType.FLOAT, default: 0 },
    minimum_viewing_ms: { type: ParameterType.INT, default: 0 },
    /** Whether "no difference" may be answered. */
    ties: { type: ParameterType.BOOL, default: false },
    /** Gives both pictures, decoded. */
    images: { type: ParameterType.FUNCTION, default: undefined },
    /** Gives their sizes for a room. */
    sizes: { type: ParameterType.FUNCTION, default: undefined },
    /** Keeps the answer; the next trial waits for it. */
    keep: { type: ParameterType.FUNCTION, default: undefined },
  },
  data: {
    chosen: { type: ParameterType.STRING },
    response_ms: { type: ParameterType.FLOAT },
  },
} as const;
type Info = typeof info;
type Description = TrialType<Info>;

/** What a pair needs, as jsPsych hands it over. */
export interface Pair {
  trial: number;
  words: PairWords;
  share: number;
  minimum_viewing_ms: number;
  ties: boolean;
  images: () => Promise<[HTMLImageElement, HTMLImageElement]>;
  sizes: (room: Room) => Sizes;
  keep: (answer: Answer) => Promise<void>;
}

export class PairPlugin implements JsPsychPlugin<Info> {
  static info = info;

  constructor(private readonly jsPsych: JsPsych) {}

  async trial(display: HTMLElement, trial: Description, loaded?: () => void) {
    return this.present(display, trial as unknown as Pair, false, loaded);
  }

  /** "visual": shown, and answered by a click or a key; "data-only": answered at once, unseen. */
  async simulate(trial: Description, mode: Simulation, _options: unknown, loaded?: () => void) {
    const pair = trial as unknown as Pair;
    const chosen = this.guess(pair);
    const response_ms = pair.minimum_viewing_ms + 50 + Math.round(150 * Math.random());
    if (mode === "visual") {
      const display = this.jsPsych.getDisplayElement();
      return this.present(display, pair, true, loaded, (view) => {
        setTimeout(() => view.act(chosen), response_ms);
      });
    }
    loaded?.();
    const shown = Date.now();
    const answer: Answer = {
      trial: pair.trial,
      chosen,
      response_ms,
      shown_at: new Date(shown).toISOString(),
      answered_at: new Date(shown + response_ms).toISOString(),
      flags: {},
      simulated: true,
    };
    await pair.keep(answer);
    return { chosen, response_ms };
  }

  private guess(pair: Pair): Chosen {
    return this.jsPsych.randomization.sampleWithoutReplacement(
      pair.ties ? ["left", "right", "tie"] : ["left", "right"],
      1,
    )[0] as Chosen;
  }

  private async present(
    display: HTMLElement,
    pair: Pair,
    simulated: boolean,
    loaded?: () => void,
    seen?: (view: PairView) => void,
  ) {
    const [left, right] = await pair.images();
    const view = new PairView(pair.words, pair.share, pair.ties, left, right, pair.sizes);
    display.append(view.root);
    const watch = new Watch(() => view.fit());
    const shrunk = view.fit();
    loaded?.();
    await new Promise((resolve) => setTimeout(resolve, CROSS_MS));
    const shown_ms = await view.reveal();
    const shown_at = new Date().toISOString();
    seen?.(view);
    const { chosen, took_ms, early } = await view.answer(shown_ms, pair.minimum_viewing_ms);
    const response_ms = took_ms > LONGEST_MS ? null : took_ms;
    const flags = watch.end();
    if (early > 0) flags["early"] = early;
    if (shrunk < 1) flags["shrunk"] = Math.round(shrunk * 1000) / 1000;
    const answered_at = new Date().toISOString();
    const answer = { trial: pair.trial, chosen, response_ms, shown_at, answered_at };
    await pair.keep({ ...answer, flags, simulated });
    return { chosen, response_ms };
  }
}
