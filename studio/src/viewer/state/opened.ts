/** A picture file that was opened to be looked at, and what a file offers to be taken from it. */

import { signal } from "@preact/signals";
import type { Layered } from "nacreous-files";
import type { Complaint, Specs } from "../specs/spec";

/** A picture of ours that holds its recipe, or an OpenEXR file with layers. */
export interface Opened {
  readonly name: string;
  /** null of a PNG, which has no layers. */
  readonly layers: Layered | null;
  /** What it was made from; null where it does not say, or cannot be used here. */
  readonly specs: Specs | null;
  /** Why its recipe cannot be used here. */
  readonly complaints: readonly Complaint[];
  /** Of a PNG: the file, which may be taken as a photograph of grain. */
  readonly photograph: Uint8Array<ArrayBuffer> | null;
}

export const opened = signal<Opened | null>(null);
/** Whether a file is being read. */
export const reading = signal("");
/** How many times files or a link were opened, whatever became of them. */
export const openings = signal(0);
