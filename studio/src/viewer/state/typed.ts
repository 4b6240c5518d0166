/** Numbers and dates as they are typed, with a Japanese keyboard too. */

import { dayOf, daysIn } from "./dates";

/** The text with full-width letters, signs and points as the narrow ones that they stand for. */
export function narrow(text: string): string {
  return text
    .normalize("NFKC")
    .replace(/[−‐‑–—ー]/g, "-")
    .replaceAll("。", ".")
    .trim();
}

/** A decimal comma: three digits behind it could be thousands, but not behind a zero. */
const COMMA = /^[-+]?(?:\d+,(?!\d{3}$)\d+|0,\d{3})$/;

/** The number that is typed, with a point or a decimal comma; NaN where it is none. */
export function numberOf(text: string): number {
  const plain = narrow(text);
  if (plain === "") return NaN;
  return Number(COMMA.test(plain) ? plain.replace(",", ".") : plain);
}

/** A day of a year as "YYYY-MM-DD", however its three numbers are parted; null where it is none. */
export function dateOf(text: string): string | null {
  const found = /^(\d{4})[-/.年](\d{1,2})[-/.月](\d{1,2})日?$/.exec(narrow(text));
  if (found === null) return null;
  const [year = "", month = "", day = ""] = found.slice(1);
  const written = `${year}-${month.padStart(2, "0")}-${day.padStart(2, "0")}`;
  return isOnCalendar(written) ? written : null;
}

function isOnCalendar(written: string): boolean {
  const found = dayOf(written);
  if (found === null || found.month < 1 || found.month > 12 || found.day < 1) return false;
  const year = Number(found.year);
  const isLeap = (year % 4 === 0 && year % 100 !== 0) || year % 400 === 0;
  const days = found.month === 2 && isLeap ? 29 : daysIn(found.month);
  return year > 0 && found.day <= days;
}
