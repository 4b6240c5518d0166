/** Rows of a picture, handed out to whichever worker is free: none of them is as fast as another all the time. */

/** Rows of the last bands: few enough that all workers end together. */
const LEAST = 4;
/** A band is this share of what each worker would still have to make: the page, which hands them out, may be slow to answer. */
const SHARE = 1 / 3;

export class Bands {
  private next = 0;

  constructor(
    private readonly size: number,
    private readonly workers: number,
  ) {}

  /** The next rows `[first, end)`; none of them once all are handed out. */
  take(): [number, number] {
    const first = this.next;
    const share = Math.round(((this.size - first) / this.workers) * SHARE);
    this.next = Math.min(first + Math.max(LEAST, share), this.size);
    return [first, this.next];
  }
}
