/** Where colours and chromaticities lie in a diagram of unit size. */

import type { MeasuredRing } from "nacreous-wasm";

export interface Spot {
  readonly x: number;
  readonly y: number;
}

/** Chromas that a wheel's circles may end at. */
const ENDS = [2, 5, 10, 20, 40, 80, 160] as const;

/** The chroma at the rim of a wheel that holds these. */
export function endOf(chromas: readonly number[]): number {
  const most = Math.max(0, ...chromas);
  return ENDS.find((end) => end >= most) ?? most;
}

/** Where a ring lies in the wheel, from -1 to 1, y up; null where it has no colour. */
export function spotOf({ colour }: MeasuredRing, end: number): Spot | null {
  if (colour === null) return null;
  const turn = ((colour.hue_deg?.value ?? 0) * Math.PI) / 180;
  const away = colour.chroma.value / end;
  return { x: away * Math.cos(turn), y: away * Math.sin(turn) };
}

/** Pairs of x and y. */
export function pairs(flat: ArrayLike<number>): Spot[] {
  return Array.from({ length: Math.floor(flat.length / 2) }, (_, i) => ({
    x: flat[2 * i] ?? 0,
    y: flat[2 * i + 1] ?? 0,
  }));
}

/** This share of pixels at either end may lie outside. */
const OUTLIERS = 0.005;

/** The part of the chart that shows all of a pearl's pixels and the white: a square. */
export function closeUp(spots: readonly Spot[], white: Spot): Spot & { readonly side: number } {
  const sorted = (values: number[]) => values.filter(Number.isFinite).sort((a, b) => a - b);
  const span = (values: number[], own: number): [number, number] => {
    const all = sorted(values);
    const far = Math.floor(OUTLIERS * all.length);
    return [Math.min(own, all[far] ?? own), Math.max(own, all.at(-1 - far) ?? own)];
  };
  const [left, right] = span(
    spots.map((one) => one.x),
    white.x,
  );
  const [low, high] = span(
    spots.map((one) => one.y),
    white.y,
  );
  const side = Math.max(0.02, 1.3 * Math.max(right - left, high - low));
  return { x: (left + right - side) / 2, y: (low + high - side) / 2, side };
}

/** The mean of those that are numbers. */
export function middleOf(spots: readonly Spot[]): Spot | null {
  const seen = spots.filter((one) => Number.isFinite(one.x + one.y));
  if (seen.length === 0) return null;
  const mean = (of: (one: Spot) => number) =>
    seen.reduce((sum, one) => sum + of(one), 0) / seen.length;
  return { x: mean((one) => one.x), y: mean((one) => one.y) };
}
