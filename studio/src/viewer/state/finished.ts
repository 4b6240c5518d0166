/** The whole pictures of both sides, while they are shown. */

import { signal } from "@preact/signals";
import type { Whole } from "../light/pool";

export interface Finished extends Whole {
  readonly recipe: string;
}

export const finished = {
  a: signal<Finished | null>(null),
  b: signal<Finished | null>(null),
};
