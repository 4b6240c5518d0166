/** The whole pictures of both sides, while they are shown. */

import { signal } from "@preact/signals";
import type { Codes } from "../light/messages";

export interface Finished {
  readonly codes: Codes;
  /** 1 of each pixel that is a pearl's. */
  readonly covered: Uint8Array<ArrayBuffer>;
  readonly widthPx: number;
}

export const finished = {
  a: signal<Finished | null>(null),
  b: signal<Finished | null>(null),
};
