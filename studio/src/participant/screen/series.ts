/** Things that are shown one after the other, each with one right answer. */

import type { Share } from "./content";

export class Series<T> {
  private at = 0;
  private right = 0;

  /** `show` is told which comes now, and `done` at the end how many answers were right. */
  constructor(
    private readonly wanted: readonly T[],
    private readonly show: (at: number) => void,
    private readonly done: (share: Share) => void,
  ) {
    show(0);
  }

  take(given: T | null): void {
    if (given === this.wanted[this.at]) this.right += 1;
    this.at += 1;
    if (this.at < this.wanted.length) this.show(this.at);
    else this.done({ right: this.right, of: this.wanted.length });
  }
}

/** Take keys that mean something; what it returns ends that. */
export function listen<T>(meaning: (key: string) => T | undefined, take: (given: T) => void) {
  const press = (event: KeyboardEvent) => {
    const given = meaning(event.key);
    if (given === undefined || event.repeat) return;
    event.preventDefault();
    take(given);
  };
  document.addEventListener("keydown", press);
  return () => document.removeEventListener("keydown", press);
}
