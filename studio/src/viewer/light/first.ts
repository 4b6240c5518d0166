/** The picture that is shown at once, before the whole one is there. */

import { type Job, type RecipeJson, type Space, develop } from "nacreous-wasm";
import type { Codes } from "./messages";

interface Drafting {
  draft(widthPx: number): Codes;
}

/** Pixels a side of the stand-in, one sample each. */
const SMALL_PX = 128;

export interface First {
  readonly codes: Codes;
  readonly widthPx: number;
}

/** A quick picture of the job's recipe; the job holds that recipe again when this returns. */
export function firstPicture(job: Job, recipe: RecipeJson, widthPx: number, space: Space): First {
  if ("draft" in job) {
    return { codes: (job as unknown as Drafting).draft(widthPx), widthPx };
  }
  const small = { ...(JSON.parse(recipe) as object), size: SMALL_PX, samples: 1 };
  job.change(JSON.stringify(small));
  const pixels = job.rows(0, SMALL_PX);
  job.look(pixels);
  job.change(recipe);
  return { codes: develop(pixels, space, "soft").codes, widthPx: SMALL_PX };
}
