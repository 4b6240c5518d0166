/** Days of the year, as "MM-DD" and "YYYY-MM-DD". */

const DAY_MS = 86_400_000;
/** A year without a leap day. */
const SOME_YEAR = 2025;

export interface Day {
  readonly year: string | null;
  readonly month: number;
  readonly day: number;
}

export function dayOf(text: string): Day | null {
  const found = /^(?:(\d{4})-)?(\d{2})-(\d{2})$/.exec(text);
  if (found === null) return null;
  return { year: found[1] ?? null, month: Number(found[2]), day: Number(found[3]) };
}

const two = (n: number) => String(n).padStart(2, "0");

export function written({ year, month, day }: Day): string {
  return `${year === null ? "" : `${year}-`}${two(month)}-${two(day)}`;
}

/** 0 for the first of January, up to 364. */
export function dayOfYear({ month, day }: Day): number {
  return (Date.UTC(SOME_YEAR, month - 1, day) - Date.UTC(SOME_YEAR, 0, 1)) / DAY_MS;
}

/** The same year's day of that number. */
export function onDay(number: number, year: string | null): Day {
  const found = new Date(Date.UTC(SOME_YEAR, 0, 1) + number * DAY_MS);
  return { year, month: found.getUTCMonth() + 1, day: found.getUTCDate() };
}

/** How many days a month always has. */
export function daysIn(month: number): number {
  return new Date(Date.UTC(SOME_YEAR, month, 0)).getUTCDate();
}
