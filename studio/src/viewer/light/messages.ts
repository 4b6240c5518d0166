/** What the page and its workers tell each other. */

import type { Developed, PearlJson, RecipeJson, Resources, Shared, Space } from "nacreous-wasm";

/** A picture that is wanted: each worker makes bands of its rows, as they are handed out. */
export interface Show {
  readonly kind: "show";
  readonly ticket: number;
  readonly recipe: RecipeJson;
  readonly resources?: Resources;
  readonly space: Space;
  /** Pixels a side of the first picture; 0 where this worker makes none. */
  readonly firstPx: number;
  /** How long after this the rows of the whole picture are begun, in ms; null where its first picture alone is wanted. */
  readonly restMs: number | null;
  /** This worker's number of all that work on the picture. */
  readonly part: number;
  readonly parts: number;
}

/** What all workers work on next before the rows: the first thing that any of them lacks; null where none lacks any. */
export interface Agreed {
  readonly kind: "agreed";
  readonly ticket: number;
  readonly round: number;
  readonly shared: Shared | null;
}

/** What all of them found, piece by piece. */
export interface Parts {
  readonly kind: "parts";
  readonly ticket: number;
  readonly round: number;
  readonly pieces: readonly Float64Array[];
}

/** Rows for a worker to make, `[first, end)`; none of them once all are handed out. */
export interface Band {
  readonly kind: "band";
  readonly ticket: number;
  readonly first: number;
  readonly end: number;
}

/** The joined pixels of a picture with glare, which needs all of them. */
export interface Look {
  readonly kind: "look";
  readonly ticket: number;
  readonly pixels: Float32Array<ArrayBuffer>;
  readonly space: Space;
}

/** What the keys come to that a pearl leaves open. */
export interface Resolve {
  readonly kind: "resolve";
  readonly question: number;
  readonly pearl: PearlJson;
}

export type ToWorker =
  | { readonly kind: "load"; readonly module: WebAssembly.Module }
  | Show
  | Agreed
  | Parts
  | Band
  | Look
  | Resolve;

export type Codes = Developed["codes"];

/** Linear light in the primaries of sRGB, three numbers a pixel. */
export type Light = Float32Array<ArrayBuffer>;

export type FromWorker =
  | {
      readonly kind: "first";
      readonly ticket: number;
      readonly codes: Codes;
      readonly widthPx: number;
      readonly tookMs: number;
    }
  | {
      readonly kind: "rows";
      readonly ticket: number;
      readonly first: number;
      readonly size: number;
      /** Codes for the screen; where there is glare, light before the look. */
      readonly made: Codes | Float32Array<ArrayBuffer>;
      /** 1 of each pixel that is a pearl's by half or more. */
      readonly covered: Uint8Array<ArrayBuffer>;
      /** Linear light, three numbers a pixel; none where there is glare. */
      readonly light: Light | null;
    }
  | {
      /** This worker takes another band. */
      readonly kind: "free";
      readonly ticket: number;
      readonly part: number;
    }
  | {
      readonly kind: "whole";
      readonly ticket: number;
      readonly codes: Codes;
      readonly light: Light;
    }
  | {
      readonly kind: "lacks";
      readonly ticket: number;
      readonly round: number;
      readonly part: number;
      /** What this worker lacks first, by what it made before. */
      readonly shared: Shared | null;
    }
  | {
      readonly kind: "part";
      readonly ticket: number;
      /** Counts what is shared out. */
      readonly round: number;
      readonly part: number;
      /** This worker's pieces: the first is the one of its own number, the next lies as many on as there are workers. */
      readonly pieces: readonly Float64Array<ArrayBuffer>[];
    }
  | {
      readonly kind: "resolved";
      readonly question: number;
      readonly keys: Readonly<Record<string, number>>;
    }
  | { readonly kind: "failed"; readonly ticket: number; readonly text: string };
