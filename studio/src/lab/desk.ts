/** What all views of the laboratory share. */

import type { Lab, Progress, Study } from "./api";
import type { Speech } from "./words/speech";

/** What a person has opened or typed, kept when the language changes. */
export interface Kept {
  tab: string;
  /** Numbers of people whose flags are explained. */
  explained: Set<number>;
  shown: "everyone" | "people" | "simulated" | "flagged";
  question: string;
  simulated: boolean;
  /** Invitation links just made, which the server never tells again. */
  links: string[];
}

export interface Desk {
  lab: Lab;
  speech: Speech;
  study: Study;
  kept: Kept;
  /** Do something that may fail; says so where it does, and looks again afterwards. */
  act(work: () => Promise<unknown>): Promise<boolean>;
}

export interface View {
  readonly node: HTMLElement;
  /** The newest figures, and that this view is seen; called every few seconds. */
  update(progress: Progress): void | Promise<void>;
}
