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

/** While things move, pictures of this size or that are shown, whichever keeps up with the hand. */
const LARGE_PX = 512;
const SMALL_PX = 256;
/** A large picture may take this long; one of a fourth of the pixels, this long before a large is tried. */
const SLOW_MS = 45;
const QUICK_MS = 14;

/** Pixels a side of the next first picture, by how long the last one took. */
export function nextPx({ widthPx, tookMs }: Pick<First, "widthPx" | "tookMs">): number {
  if (widthPx <= SMALL_PX) return tookMs < QUICK_MS ? LARGE_PX : SMALL_PX;
  return tookMs > SLOW_MS ? SMALL_PX : LARGE_PX;
}
