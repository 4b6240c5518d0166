/** What the page asks of the worker that opens and saves files, and what it answers. */

import type { Grain, Layered, LinearPicture } from "nacreous-files";
import type { Difference, RecipeJson, Resources, Space } from "nacreous-wasm";
import type { Codes } from "./messages";

type Bytes = Uint8Array<ArrayBuffer>;

/** By its name: what is asked, and what is answered. */
export interface Requests {
  readonly panorama: readonly [{ readonly bytes: Bytes }, LinearPicture];
  readonly light: readonly [
    { readonly text: string; readonly place: string },
    Float64Array<ArrayBuffer>,
  ];
  readonly grain: readonly [{ readonly bytes: Bytes; readonly how: GrainKeys }, Grain];
  readonly exr: readonly [{ readonly bytes: Bytes }, Layered];
  readonly pngTexts: readonly [{ readonly bytes: Bytes }, readonly (readonly [string, string])[]];
  readonly save: readonly [Saved, Bytes];
  readonly mark: readonly [Marked, Bytes];
  readonly codes: readonly [
    { readonly rgb: Float32Array<ArrayBuffer>; readonly space: Space },
    Codes,
  ];
  readonly difference: readonly [
    {
      readonly first: Codes;
      readonly second: Codes;
      readonly covered: Bytes;
      readonly space: Space;
    },
    Difference,
  ];
}

export type Request = keyof Requests;

/** A pearl's keys by which the grain on a photograph is measured. */
export interface GrainKeys {
  readonly side_px: number;
  readonly mm_per_pixel: number | null;
  readonly low_per_mm: number | null;
  readonly high_per_mm: number | null;
}

/** What a file keeps of the recipe that it is made by. */
export interface Kept {
  readonly samples: number;
  /** The recipe's pearls in JSON and their growth's seeds, for the settings. */
  readonly pearls: readonly { readonly json: string; readonly seed: string }[];
  /** Texts by keyword without what each of ours begins with. */
  readonly texts: readonly (readonly [keyword: string, text: string])[];
}

/** A picture to be rendered and written with its layers. */
export interface Saved extends Kept {
  readonly recipe: RecipeJson;
  readonly resources: Resources | undefined;
}

/** A PNG of the screen's codes, that is to keep its recipe. */
export interface Marked extends Kept {
  readonly png: Bytes;
  readonly size: number;
  readonly space: Space;
}

export interface Ask<R extends Request = Request> {
  readonly kind: R;
  readonly given: Requests[R][0];
  readonly program: WebAssembly.Module | null;
  readonly files: WebAssembly.Module | null;
}

export type Answer =
  | { readonly ok: true; readonly value: Requests[Request][1] }
  | { readonly ok: false; readonly text: string };
