/** How the page is looked at; no part of a spec, and not undone. */

import { signal } from "@preact/signals";

export type Tab = "presets" | "pearl" | "scene" | "compare" | "instruments";

export const tab = signal<Tab>("pearl");

/** Whether A and B share one place, parted by a line, or stand side by side. */
export const wiping = signal(false);
/** Where that line is, as a share of the width. */
export const wipe = signal(0.5);

/** Pixels a side of the picture at rest. */
export const SIZES = [256, 512, 1024] as const;
export const size = signal<number>(512);
