/** Layers by depth, with the days on which they grew. */

import type { Layers } from "../light/instruments";
import { dayOf } from "./dates";

const DAY_MS = 86_400_000;
/** Stands for "every year"; not a leap year. */
const SOME_YEAR = 2001;

export interface Layer {
  /** Of the layer's middle, aragonite and protein above it counted. */
  readonly depthUm: number;
  readonly thicknessNm: number;
  /** "YYYY-MM-DD", "MM-DD" where every year is alike, "" of listed layers. */
  readonly date: string;
  /** 1 at the top of the season, towards 0 in winter. */
  readonly warmth: number;
}

/** The day that lies so many days after another, written as that one is. */
export function dayAfter(seeding: string, days: number): string {
  const day = dayOf(seeding);
  if (day === null) return "";
  const since = Date.UTC(Number(day.year ?? SOME_YEAR), day.month - 1, day.day);
  const text = new Date(since + days * DAY_MS).toISOString();
  return text.slice(day.year === null ? 5 : 0, 10);
}

/** The layers down to a depth, the surface first. */
export function outer(
  { thicknessNm, proteinNm, seeding, grown }: Layers,
  mostUm = Infinity,
): Layer[] {
  const found: Layer[] = [];
  let top = 0;
  for (const [i, thickness] of thicknessNm.entries()) {
    const depthUm = (top + thickness / 2) / 1000;
    if (depthUm > mostUm) break;
    found.push({
      depthUm,
      thicknessNm: thickness,
      date: grown === null ? "" : dayAfter(seeding, grown.day[i] ?? 0),
      warmth: grown?.warmth[i] ?? 0,
    });
    top += thickness + proteinNm;
  }
  return found;
}
