/** The pearls that were chosen for a study. */

import { signal } from "@preact/signals";
import type { Specs } from "../specs/spec";

export interface Chosen {
  readonly label: string;
  readonly specs: Specs;
}

/** A study takes two to 64. */
export const MOST_CHOSEN = 64;

export const chosen = signal<readonly Chosen[]>([]);

/** Adds a pearl under a label that no other has. */
export function choose(specs: Specs, name: string): void {
  if (chosen.value.length >= MOST_CHOSEN) return;
  const taken = new Set(chosen.value.map((one) => one.label));
  let label = name;
  for (let n = 2; taken.has(label); n += 1) label = `${name} ${n}`;
  chosen.value = [...chosen.value, { label, specs }];
}

export function leaveOut(label: string): void {
  chosen.value = chosen.value.filter((one) => one.label !== label);
}
