/** The picture that is shown at once, before the whole one is there. */

import type { Job, Space } from "nacreous-wasm";
import type { Codes } from "./messages";

export interface First {
  readonly codes: Codes;
  readonly widthPx: number;
  readonly tookMs: number;
}

export function firstPicture(job: Job, widthPx: number, space: Space): First {
  const began = performance.now();
  const codes = job.preview(widthPx, space, "soft");
  return { codes, widthPx, tookMs: performance.now() - began };
}

/** A change of what is seen shows small pictures while it lasts; one of light's colours alone large ones. */
export const LARGE_PX = 512;
export const SMALL_PX = 256;
/** Where so many large pictures on end take longer, small ones follow the hand; one in some tries a large one again. */
const SLOW_MS = 90;
const ON_END = 3; // the first ones work out much that stays
const TRY_AGAIN = 10;

/** Pixels a side of first pictures, by what has changed and how long large ones took. */
export class FirstSize {
  private slow = 0;
  private since = 0;

  next(changesView: boolean): number {
    if (changesView) return SMALL_PX;
    if (this.slow < ON_END) return LARGE_PX;
    this.since = (this.since + 1) % TRY_AGAIN;
    return this.since === 0 ? LARGE_PX : SMALL_PX;
  }

  learn({ widthPx, tookMs }: Pick<First, "widthPx" | "tookMs">): void {
    if (widthPx > SMALL_PX) this.slow = tookMs > SLOW_MS ? this.slow + 1 : 0;
  }
}
