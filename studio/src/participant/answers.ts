/** An answer's way: into the browser's log, then to the server. */

import type { Problem } from "../shared/http";
import type { Answer, Api } from "./api";
import type { Log } from "./storage/log";
import { resume } from "./storage/resume";
import { Sender } from "./storage/sender";
import { pause } from "./reach";

export class Answers {
  /** Rejects when the server will take no more; otherwise never ends. */
  readonly refused: Promise<never>;
  private readonly sender: Sender;

  constructor(
    api: Api,
    private readonly log: Log,
    connected: (yes: boolean) => void,
  ) {
    let refuse: (problem: Problem) => void = () => undefined;
    this.refused = new Promise((_, reject) => (refuse = reject));
    this.refused.catch(() => undefined); // heard by those who race against it
    this.sender = new Sender({
      put: (answer) => api.answer(answer),
      missing: async () => resume((await api.sitting()).answered, await log.all()).unsent,
      connected,
      refused: refuse,
      pause,
    });
    addEventListener("beforeunload", (event) => {
      if (!log.lasting && this.waiting > 0) event.preventDefault();
    });
  }

  /** How many answers the server has not acknowledged. */
  get waiting(): number {
    return this.sender.waiting;
  }

  /** Send what only this browser has; gives the first trial without an answer. */
  async resume(answered: number): Promise<number> {
    const { next, unsent } = resume(answered, await this.log.all());
    if (unsent.length > 0) this.sender.add(...unsent);
    return next;
  }

  /** Keep an answer, then send it; waits for the disk, not for the network. */
  async keep(answer: Answer): Promise<void> {
    let kept = answer;
    try {
      await this.log.add(answer);
    } catch {
      kept = marked(answer); // the browser's disk is full, perhaps
    }
    this.sender.add(this.log.lasting ? kept : marked(answer));
  }

  /** Resolves when every answer is acknowledged. */
  settled(): Promise<void> {
    return this.sender.settled();
  }
}

/** The server alone has this answer. */
function marked(answer: Answer): Answer {
  return { ...answer, flags: { ...answer.flags, not_kept: true } };
}
