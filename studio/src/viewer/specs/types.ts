/** What every part of `specs` speaks of: pearls and scenes, and what is wrong with one. */

import type * as complete from "./complete";

/** A value that nobody changes in place. */
export type Unchanging<T> = T extends readonly unknown[] | object
  ? { readonly [K in keyof T]: Unchanging<T[K]> }
  : T;

export type Kind = "pearl" | "scene";

/** A pearl in which every key of its model stands, with null where the renderer finds the value. */
export type Pearl = Unchanging<complete.Pearl>;

/** The layers of a pearl: grown, or listed. */
export type Nacre = Pearl["nacre"];

/** A scene likewise. */
export type Scene = Unchanging<complete.Scene>;

export interface Specs {
  readonly pearl: Pearl;
  readonly scene: Scene;
}

/** What is wrong: `path` is the dotted key, "" of the whole file; `text` the command line's line. */
export interface Complaint {
  readonly path: string;
  readonly text: string;
  /** What is wrong with the key, without file and key before it; of a whole file there is none. */
  readonly verdict?: string;
}

export type Read<T> =
  | { readonly ok: true; readonly value: T }
  | { readonly ok: false; readonly complaints: readonly Complaint[] };

/** A key as it is declared in `nacreous/spec/`. */
export interface Declaration {
  /** `nacre.protein_nm`; in a list, its first entry's, as `lamps.0.intensity`. */
  readonly path: string;
  readonly unit: string;
  readonly least: number | null;
  readonly most: number | null;
  readonly leastExcluded: boolean;
  readonly mostExcluded: boolean;
  readonly isWhole: boolean;
  readonly choices?: readonly string[];
  /** null where the key has none: it is open, or must be given. */
  readonly default: unknown;
  /** The only model that has the key. */
  readonly model?: "transport" | "illuminant";
  readonly meaning: string;
  /** The phrase of all messages. */
  readonly allowed: string;
  readonly isOpen: boolean;
  /** The endings of a key that may name a file. */
  readonly files: readonly string[];
}

/** A complaint that nothing can be made of: the specs ask for what is not there. */
export class Refusal extends Error {}
