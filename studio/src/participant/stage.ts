/** Where jsPsych plays: every page and every pair is one of its trials. */

import { initJsPsych, ParameterType } from "jspsych";
import type { JsPsych, JsPsychPlugin, TrialType } from "jspsych";
import { element } from "../shared/dom";

export type Simulation = "data-only" | "visual";

/** A page that is read, filled in or looked at, and left with a result. */
export interface Page<T> {
  /** Of one word, for the style sheet and the tests. */
  name: string;
  /** Draw into an empty element and call `done` once. What it returns is called when it is left. */
  draw(into: HTMLElement, done: (result: T) => void): (() => void) | void;
  /** Do what a participant would, for a simulation; pages without it are shown even then. */
  play?: (into: HTMLElement) => void;
}

const info = {
  name: "nacreous-page",
  version: "1.0.0",
  parameters: {
    draw: { type: ParameterType.FUNCTION, default: undefined },
    play: { type: ParameterType.FUNCTION, default: null },
  },
  data: {},
} as const;
type Info = typeof info;

/** jsPsych's plugin for a `Page`. */
class PagePlugin implements JsPsychPlugin<Info> {
  static info = info;

  constructor(private readonly jsPsych: JsPsych) {}

  trial(display: HTMLElement, trial: TrialType<Info>, loaded?: () => void): Promise<void> {
    return new Promise((resolve) => {
      trial.draw(display, resolve);
      loaded?.();
    });
  }

  /** The same page, played; where only data is wanted, played without being seen. */
  simulate(
    trial: TrialType<Info>,
    mode: Simulation,
    _options: unknown,
    loaded?: () => void,
  ): Promise<void> {
    const seen = mode === "visual";
    const display = seen ? this.jsPsych.getDisplayElement() : element("div");
    const finished = this.trial(display, trial, loaded);
    setTimeout(() => trial.play?.(display), seen ? 300 : 0);
    return finished;
  }
}

type TimelineArray = Parameters<JsPsych["simulate"]>[0];

export class Stage {
  constructor(
    private readonly root: HTMLElement,
    readonly simulation: Simulation | null,
  ) {}

  /** Show one page and give back what it is left with. */
  async show<T>(page: Page<T>): Promise<T> {
    let result: { is: T } | null = null;
    await this.run([this.trialOf(page, (told) => (result = { is: told }))]);
    if (result === null) throw new Error(`the page ${page.name} was left without a result`);
    return (result as { is: T }).is;
  }

  /** A page as a trial of a longer timeline. */
  trialOf<T>(page: Page<T>, told: (result: T) => void) {
    let leave: (() => void) | void;
    return {
      type: PagePlugin,
      css_classes: ["page", `page-${page.name}`],
      draw: (into: HTMLElement, done: () => void) => {
        leave = page.draw(into, (result) => {
          told(result);
          done();
        });
      },
      play: page.play ?? null,
      simulation_options: { simulate: page.play !== undefined },
      on_finish: () => leave?.(),
    };
  }

  /** Run a timeline in a fresh place, simulated where the address asks for it. */
  async run(timeline: TimelineArray): Promise<void> {
    const place = element("div", { class: "stage" });
    this.root.replaceChildren(place);
    const jsPsych = initJsPsych({ display_element: place, use_webaudio: false });
    if (this.simulation === null) await jsPsych.run(timeline);
    else await jsPsych.simulate(timeline, this.simulation);
  }
}
