/** Answers on their way to the server: in order, one at a time, and again until they are there. */

import { Problem } from "../../shared/http";
import type { Answer } from "../api";

const FIRST_WAIT_MS = 500;
const LONGEST_WAIT_MS = 8_000;

interface Way {
  /** Hand one answer in; throws `Problem`. */
  put(answer: Answer): Promise<void>;
  /** The answers that the server lacks, told when it says that one comes before its turn. */
  missing(): Promise<Answer[]>;
  /** Told with every change whether the last attempt reached the server. */
  connected(yes: boolean): void;
  /** The server will take no more: why. */
  refused(problem: Problem): void;
  /** Wait before the next attempt. */
  pause(wait_ms: number): Promise<void>;
}

export class Sender {
  /** Trials that the server had another answer for; its own stays. */
  readonly conflicts: number[] = [];
  private queue: Answer[] = [];
  private running: Promise<void> | null = null;
  private failures = 0;
  private stopped = false;

  constructor(private readonly way: Way) {}

  /** How many answers are not acknowledged yet. */
  get waiting(): number {
    return this.queue.length;
  }

  /** Send an answer as soon as those before it are there. */
  add(...answers: Answer[]): void {
    this.queue.push(...answers);
    this.running ??= this.run();
  }

  /** Resolves when nothing is on its way any more. */
  async settled(): Promise<void> {
    await this.running;
  }

  private async run(): Promise<void> {
    try {
      for (let answer = this.queue[0]; answer && !this.stopped; answer = this.queue[0]) {
        await this.put(answer);
      }
    } finally {
      this.running = null; // here and not a moment later, in which an answer could be added
    }
  }

  private async put(answer: Answer): Promise<void> {
    try {
      await this.way.put(answer);
      this.arrived();
    } catch (reason) {
      if (!(reason instanceof Problem)) throw reason;
      await this.failed(reason, answer);
    }
  }

  private arrived(): void {
    this.queue.shift();
    this.failures = 0;
    this.way.connected(true);
  }

  private async failed(problem: Problem, answer: Answer): Promise<void> {
    if (problem.passes) {
      this.failures += 1;
      this.way.connected(false);
      await this.way.pause(Math.max(problem.retryAfterMs, backoff_ms(this.failures)));
    } else if (problem.kind === "conflict") {
      this.conflicts.push(answer.trial);
      this.arrived();
    } else if (problem.kind === "turn") {
      await this.catchUp(problem, answer);
    } else {
      this.stop(problem);
    }
  }

  /** A server that was restored from a backup lacks answers that it once acknowledged. */
  private async catchUp(problem: Problem, answer: Answer): Promise<void> {
    let missing: Answer[];
    try {
      missing = await this.way.missing();
    } catch (reason) {
      if (!(reason instanceof Problem)) throw reason;
      return this.failed(reason, answer);
    }
    const first = missing[0];
    if (first === undefined || first.trial >= answer.trial) {
      this.stop(problem);
      return;
    }
    const last = Math.max(...missing.map(({ trial }) => trial));
    this.queue = [...missing, ...this.queue.filter(({ trial }) => trial > last)];
  }

  private stop(problem: Problem): void {
    this.stopped = true;
    this.way.refused(problem);
  }
}

/** Half a second, twice that after each failure, up to eight seconds; a fifth of it by chance. */
export function backoff_ms(failures: number, chance = Math.random()): number {
  const wait_ms = Math.min(LONGEST_WAIT_MS, FIRST_WAIT_MS * 2 ** (failures - 1));
  return wait_ms * (0.9 + 0.2 * chance);
}
