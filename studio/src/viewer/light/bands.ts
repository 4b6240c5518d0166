/** Rows of a picture, handed out to whichever worker is free: none of them is as fast as another all the time. */

/** Rows of a band: enough to be worth a message, few enough that all workers end together. */
const BAND = 4;

export class Bands {
  private next = 0;

  constructor(private readonly size: number) {}

  /** The next rows `[first, end)`; none of them once all are handed out. */
  take(): [number, number] {
    const first = this.next;
    this.next = Math.min(first + BAND, this.size);
    return [first, this.next];
  }
}
