/** The trade's word for a value: the table of `nacreous words`. */

import table from "../words/trade.json";
import type { Language } from "../words/speech";

interface Bound {
  readonly key: string | null;
  readonly lower: number | null;
  readonly upper: number | null;
}

/** Sizes are numbers already. */
const UNSAID = ["size"];

/** The factor of a pearl's nacre goes by its kind. */
function isOfKind(factor: string, pearl: string): boolean {
  if (!factor.startsWith("nacre-")) return true;
  const kinds = ["tahitian", "south-sea"];
  const kind = kinds.find((one) => pearl.startsWith(one)) ?? "akoya";
  return factor === `nacre-${kind}`;
}

function holds({ lower, upper }: Bound, value: number): boolean {
  const told = (lower ?? 0) > 0 || upper !== null; // from zero up without an end tells nothing
  return told && value >= (lower ?? -Infinity) && value < (upper ?? Infinity);
}

/** What the trade says of this value of a key; null where it says nothing. */
export function wordFor(
  key: string,
  value: number,
  pearl: string,
  language: Language,
): string | null {
  for (const factor of table) {
    if (UNSAID.includes(factor.factor) || !isOfKind(factor.factor, pearl)) continue;
    for (const word of factor.words) {
      const bounds = (word.ranges as readonly Bound[]).filter((one) => one.key === key);
      const last = bounds.some((one) => one.upper === value); // the end of the range belongs to it
      if (bounds.some((one) => holds(one, value)) || (last && value >= 1)) return word[language];
    }
  }
  return null;
}
