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
  if (least > 0 && most / least > WIDE) {
    const span = Math.log(most / least);
    return {
      toShare: (value) => Math.log(Math.max(value, least) / least) / span,
      fromShare: ended((share) => round(Number((least * Math.exp(span * share)).toPrecision(3)))),
      isWhole,
    };
  }
  const power = least === 0 && most > LONG ? 3 : 1;
  return {
    toShare: (value) => ((value - least) / (most - least)) ** (1 / power),
    fromShare: ended((share) => round(least + (most - least) * share ** power)),
    isWhole,
  };
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
