/**
 * What looks at single values beyond their declared type and range: the functions that keys in
 * `nacreous/spec/` are annotated with, by the same names.
 */

import { NACRES, PEARLS } from "./presets";
import { isDay } from "./toml/moment";
import { Moment, type Value } from "./value";
import { letters, printable } from "./words";

/** Any year that is not a leap year stands for "every year". */
const EVERY_YEAR = 2001;

/** Before types and ranges are looked at. */
export const BEFORE: Readonly<Record<string, (value: Value) => Value>> = {
  /** growth.py: TOML's days mean the same as texts. */
  _as_text: (value) => (value instanceof Moment && value.isDay ? value.text : value),
  /** medium.py: Python's tuples, which need nothing here. */
  _pair: (value) => value,
};

/** Of a text of the right form: what it is then, or undefined where it is refused. */
export const AFTER: Readonly<Record<string, (text: string, table: string) => string | undefined>> =
  {
    /** texts.py */
    _one_line: (text) => {
      const line = text.replace(/^[ \u3000]+|[ \u3000]+$/g, "").normalize("NFC");
      return letters(line) > 0 && printable(line) === line ? line : undefined;
    },
    /** texts.py */
    _temperature: (text) => {
      const kelvin = /^([0-9]+)K$/.exec(text)?.[1];
      if (kelvin === undefined) return text;
      return Number(kelvin) >= 1000 && Number(kelvin) <= 25000 ? text : undefined;
    },
    /** growth.py */
    _on_calendar: (text) => (dateOf(text) === undefined ? undefined : text),
    /** growth.py and row.py */
    _known: (name, table) => {
      if (table === "Growth") return NACRES.has(name) ? name : undefined;
      const isOther = name.startsWith("*") || /\.toml$/i.test(name);
      return isOther || PEARLS.has(name) ? name : undefined;
    },
  };

/** growth.py `_date`, as days since 1970; undefined of no day of the calendar. */
export function dateOf(text: string, year = EVERY_YEAR): number | undefined {
  const [day, month, given] = text.split("-").map(Number).reverse();
  if (month === undefined || day === undefined || !isDay(given ?? year, month, day)) {
    return undefined;
  }
  const date = new Date(0);
  date.setUTCFullYear(given ?? year, month - 1, day);
  return date.getTime() / 86_400_000;
}

/** The year of a day, of one without a year that of every year. */
export function yearOf(text: string): number {
  return text.length > 5 ? Number(text.slice(0, 4)) : EVERY_YEAR;
}
