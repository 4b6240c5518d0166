/** How large pictures are drawn. */

import type { Picture } from "./api";

/** CSS's own idea of a millimetre, 96 px an inch: for where nobody measured the screen. */
export const NOMINAL_PX_PER_MM = 96 / 25.4;

/** Between the two pictures, in CSS pixels. */
export const GAP_PX = 48;
export const NARROW_GAP_PX = 12;

export interface Scale {
  /** CSS pixels a millimetre as measured; null where it was not. */
  measured: number | null;
  /** The ratio of device pixels to CSS pixels when it was measured: zooming changes both. */
  ratio: number;
}

/** CSS pixels a millimetre now: a zoomed page has larger CSS pixels, and so fewer to a millimetre. */
export function pxPerMm(scale: Scale, ratioNow: number): number {
  return scale.measured === null ? NOMINAL_PX_PER_MM : (scale.measured * scale.ratio) / ratioNow;
}

export interface Room {
  width_px: number;
  height_px: number;
}

/**
 * By how much all pictures of a sitting are drawn smaller so that the two widest fit side by side
 * and the highest fits: 1 where they do. One figure for all, so that sizes stay comparable.
 */
export function shrinkage(pictures: readonly Picture[], px_per_mm: number, room: Room): number {
  const widths = pictures.map(({ width_mm }) => width_mm).sort((one, other) => other - one);
  const heights = pictures.map((picture) => height_mm(picture));
  const both_px = ((widths[0] ?? 0) + (widths[1] ?? widths[0] ?? 0)) * px_per_mm;
  const highest_px = Math.max(0, ...heights) * px_per_mm;
  const gap_px = room.width_px < 640 ? NARROW_GAP_PX : GAP_PX;
  const across = Math.max(1, room.width_px - gap_px) / Math.max(both_px, 1);
  const down = Math.max(1, room.height_px) / Math.max(highest_px, 1);
  return Math.min(1, across, down);
}

/** Width and height of a picture on the page, in CSS pixels. */
export function drawn(picture: Picture, px_per_mm: number, shrunk: number): Room {
  return {
    width_px: picture.width_mm * px_per_mm * shrunk,
    height_px: height_mm(picture) * px_per_mm * shrunk,
  };
}

function height_mm(picture: Picture): number {
  return (picture.width_mm * picture.height_px) / picture.width_px;
}
