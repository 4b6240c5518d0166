/** Where a value stands on a slider, and numbers written short. */

import type { Declaration } from "../specs/spec";

export interface Scale {
  toShare(value: number): number;
  fromShare(share: number): number;
  readonly isWhole: boolean;
}

/** So many steps has a slider. */
export const STEPS = 1000;
/** Beyond this ratio of its ends a range is told by its logarithm. */
const WIDE = 50;
/** From zero up to more than this, small values get most of the slider. */
const LONG = 40;

type Range = Pick<Declaration, "least" | "most" | "isWhole">;
type Declared = Range & Pick<Declaration, "leastExcluded" | "mostExcluded">;

const isWide = (least: number, most: number) => least > 0 && most / least > WIDE;
const isLong = (least: number, most: number) => least === 0 && most > LONG;
/** Whether small values get more of the slider than large ones. */
const isByDigits = (least: number, most: number) => isWide(least, most) || isLong(least, most);

/** A slider over a declared range; null where the range has no end or is a mere seed's. */
export function scaleOf({ least, most, isWhole }: Range): Scale | null {
  if (least === null || most === null || most > 1e7) return null;
  const ended = (of: (share: number) => number) => (share: number) =>
    share <= 0 ? least : share >= 1 ? most : of(share);
  const round = (value: number) => {
    const within = Math.min(
      most,
      Math.max(least, isWhole ? Math.round(value) : neat(value, least, most)),
    );
    return within;
  };
  if (isWide(least, most)) {
    const span = Math.log(most / least);
    return {
      toShare: (value) => Math.log(Math.max(value, least) / least) / span,
      fromShare: ended((share) => round(Number((least * Math.exp(span * share)).toPrecision(3)))),
      isWhole,
    };
  }
  const power = isLong(least, most) ? 3 : 1;
  return {
    toShare: (value) => ((value - least) / (most - least)) ** (1 / power),
    fromShare: ended((share) => round(least + (most - least) * share ** power)),
    isWhole,
  };
}

/** Digits of the value that one press of an arrow key changes, where small values have small steps. */
const KEY_DIGITS = 3;
/** Digits behind those that are kept of a typed value. */
const SPARE_DIGITS = 4;

/** The value one press of an arrow key further; the same only at its end. The press back gives it back. */
export function pressed(value: number, by: 1 | -1, range: Declared): number {
  const [least, most] = [range.least ?? -Infinity, range.most ?? Infinity];
  const step = stepAt(value, by, range);
  const digits = Math.max(0, -Math.floor(Math.log10(step))) + SPARE_DIGITS;
  const next = Number((value + by * step).toFixed(digits));
  const within = Math.min(most, Math.max(least, next));
  const isExcluded =
    (range.leastExcluded && within === least) || (range.mostExcluded && within === most);
  return isExcluded ? value : within;
}

function stepAt(value: number, by: 1 | -1, { least, most, isWhole }: Range): number {
  if (isWhole) return 1;
  const [low, high] = [least ?? 0, most ?? 1];
  if (!isByDigits(low, high)) return 10 ** Math.round(Math.log10((high - low) / STEPS));
  const finest = low > 0 ? 0 : 10 ** Math.ceil(Math.log10(high) - 5);
  const decade = Math.floor(Math.log10(Math.max(value, Number.MIN_VALUE)) + 1e-12);
  const step = 10 ** (decade + 1 - KEY_DIGITS);
  // Down from 10 it is the step of 9.99, so that the way back is the same.
  const leaves = by < 0 && value - step < 10 ** decade * (1 - 1e-12);
  return Math.max(finest, leaves ? step / 10 : step);
}

/** A value with no more digits than the range asks for. */
function neat(value: number, least: number, most: number): number {
  const digits = Math.max(0, 3 - Math.floor(Math.log10(Math.max(most - least, 1e-6))));
  return Number(value.toFixed(Math.min(6, value < 1 && value > 0 ? digits + 2 : digits)));
}

/** A number as a person would write it. */
export function short(value: number): string {
  return String(Number(value.toPrecision(5)));
}
