/** A worker of its own for the instruments: no picture waits for it. */

import type { Measures, RecipeJson } from "nacreous-wasm";
import type { Light } from "./messages";

/** What the eye meets in the middle of a pixel, and what the film there does with light. */
export interface Reading {
  readonly row: number;
  readonly column: number;
  /** The pearl's number among those of the recipe. */
  readonly pearl: number;
  readonly angleRad: number;
  /** Exact, unpolarised, of `WAVELENGTH_NM`; null with the reason where there is no film. */
  readonly film: { readonly R: Float64Array; readonly T: Float64Array } | null;
  readonly why: string;
}

/** The layers of a pearl, the surface first. */
export interface Layers {
  readonly thicknessNm: Float64Array;
  readonly proteinNm: number;
  /** "" of listed layers. */
  readonly seeding: string;
  /** How deep the film goes that is seen; null where the model has no film. */
  readonly filmUm: number | null;
  /** Days since seeding and how summery each was; null of listed layers. */
  readonly grown: { readonly day: Uint32Array; readonly warmth: Float64Array } | null;
}

/** What is measured in a finished picture. */
export interface Found {
  readonly measures: Measures | null;
  /** Why nothing was measured at all. */
  readonly why: string;
  /** x, y of pixels of the pearl, flat; none where it was not found. */
  readonly xy: Float32Array;
  /** Codes RGBA of sRGB of each ring's colour, and of one with thrice its chroma; black where it has none. */
  readonly ringCodes: Uint8ClampedArray;
}

/** Where all colours lie that can be seen, and those that screens show: x, y, flat. */
export interface Chart {
  readonly locus: Float64Array;
  readonly srgb: Float64Array;
  readonly p3: Float64Array;
}

interface Asks {
  readonly point: { readonly recipe: RecipeJson; readonly row: number; readonly column: number };
  readonly layers: { readonly recipe: RecipeJson; readonly pearl: number };
  readonly found: {
    readonly recipe: RecipeJson;
    readonly size: number;
    readonly light: Light;
  };
  readonly chart: Record<string, never>;
}

interface Answers {
  /** null beside all pearls. */
  readonly point: Reading | null;
  readonly layers: Layers;
  readonly found: Found;
  readonly chart: Chart;
}

export type Asked = {
  [K in keyof Asks]: { readonly kind: K; readonly question: number } & Asks[K];
}[keyof Asks];

export type Answered =
  | { readonly question: number; readonly answer: Answers[keyof Answers] }
  | { readonly question: number; readonly refused: string };

/** Wavelengths of the spectra: 380 to 780 nm by 2 nm. */
export const WAVELENGTH_NM = Float64Array.from({ length: 201 }, (_, i) => 380 + 2 * i);

export class InstrumentWorker {
  private readonly worker: Worker;
  private readonly ready: Promise<void>;
  private question = 0;
  private readonly open = new Map<number, [(answer: unknown) => void, (why: Error) => void]>();

  constructor(program: Promise<WebAssembly.Module>) {
    this.worker = new Worker(new URL("./instrument.worker.ts", import.meta.url), {
      type: "module",
    });
    this.worker.onmessage = ({ data }: MessageEvent<Answered>) => {
      const [done, failed] = this.open.get(data.question) ?? [];
      this.open.delete(data.question);
      if ("refused" in data) failed?.(new Error(data.refused));
      else done?.(data.answer);
    };
    this.ready = program.then((module) => this.worker.postMessage(module));
  }

  ask<K extends keyof Asks>(kind: K, asked: Asks[K]): Promise<Answers[K]> {
    this.question += 1;
    const { question } = this;
    const answer = new Promise<unknown>((done, failed) => this.open.set(question, [done, failed]));
    return this.ready.then(() => {
      this.worker.postMessage({ kind, question, ...asked });
      return answer as Promise<Answers[K]>;
    });
  }
}
