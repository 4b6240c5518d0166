/** Every answer of a sitting, kept in the browser before anything else is done with it. */

import type { Answer } from "../api";
import { read, write } from "./database";

export interface Log {
  /** Whether the log outlives the page. */
  readonly lasting: boolean;
  /** Keep an answer; it is on the disk when this resolves. The first one for a trial stays. */
  add(answer: Answer): Promise<void>;
  /** All answers kept, by trial. */
  all(): Promise<Answer[]>;
}

/** A log in IndexedDB: answers are added, and never changed or removed. */
export class LastingLog implements Log {
  readonly lasting = true;

  constructor(
    private readonly database: IDBDatabase,
    private readonly sitting: string,
  ) {}

  async add(answer: Answer): Promise<void> {
    try {
      await write(this.database, "answers", (store) => {
        store.add({ sitting: this.sitting, ...answer });
      });
    } catch (reason) {
      if (!(reason instanceof DOMException && reason.name === "ConstraintError")) throw reason;
    }
  }

  async all(): Promise<Answer[]> {
    const range = IDBKeyRange.bound([this.sitting, 0], [this.sitting, Infinity]);
    const rows = await read<(Answer & { sitting: string })[]>(this.database, "answers", (store) =>
      store.getAll(range),
    );
    return rows.map(({ sitting: _, ...answer }) => answer);
  }
}

/** Where the browser keeps nothing: the answers of this page alone, until it is left. */
export class PassingLog implements Log {
  readonly lasting = false;
  private readonly answers = new Map<number, Answer>();

  async add(answer: Answer): Promise<void> {
    if (!this.answers.has(answer.trial)) this.answers.set(answer.trial, answer);
  }

  async all(): Promise<Answer[]> {
    return [...this.answers.values()].sort((one, other) => one.trial - other.trial);
  }
}
