/** Values and keys as messages show them: `nacreous/spec/complaint.py`, `printable.py`. */

import { repr } from "./number";
import { Moment, type Value } from "./value";

/** Neither control nor invisible nor unassigned; spaces of any width and joiners are shown. */
const SHOWN = /^[^\p{C}\p{Zl}\p{Zp}]$|^[\u200c\u200d]$/u;
/** What Python agrees to print of a whole number. */
const MOST_DIGITS = 4300;

/** The text with what could move or hide text as \u and its number. */
export function printable(text: string): string {
  return Array.from(text, (letter) => (SHOWN.test(letter) ? letter : byNumber(letter))).join("");
}

function byNumber(letter: string): string {
  const code = letter.codePointAt(0) ?? 0;
  return code < 0x10000
    ? `\\u${code.toString(16).padStart(4, "0")}`
    : `\\U${code.toString(16).padStart(8, "0")}`;
}

/** A value as it would stand in the file, on one line and never long. */
export function shown(value: Value, longest = 60): string {
  if (value === null) return "nothing";
  if (value instanceof Map) return "a table";
  if (Array.isArray(value)) {
    const text = `[${value
      .slice(0, longest)
      .map((item) => shown(item))
      .join(", ")}]`;
    return letters(text) <= longest ? text : `a list of ${value.length}`;
  }
  if (typeof value === "boolean") return String(value);
  if (typeof value === "string") return printable(JSON.stringify(cut(value, longest)));
  if (typeof value === "bigint") {
    // By sixteens first, which takes no time for a million digits.
    const isLong = value.toString(16).length > MOST_DIGITS;
    const digits = isLong ? "" : value.toString();
    if (isLong || digits.replace("-", "").length > MOST_DIGITS) {
      return "a number of thousands of digits";
    }
    return cut(digits, longest);
  }
  return printable(cut(value instanceof Moment ? value.text : repr(value), longest));
}

/** Letters as Python counts them. */
export function letters(text: string): number {
  let count = 0;
  for (const _ of text) count += 1;
  return count;
}

function cut(text: string, longest: number): string {
  if (text.length <= longest || letters(text) <= longest) return text;
  return `${Array.from(text.slice(0, 2 * longest))
    .slice(0, longest - 3)
    .join("")}...`;
}

/** A key as it would stand in the file: bare where it can be. */
export function shownKey(key: string): string {
  return /^[A-Za-z0-9_-]+$/.test(key) ? key : shown(key);
}

/** The name of a file as it stands in messages, on one line. */
export function label(file: string): string {
  return printable(file) === file ? file : shown(file, 200);
}

/** The choice that a mistyped word most probably meant: Python's `difflib.get_close_matches`. */
export function nearest(word: string, choices: readonly string[]): string | undefined {
  const byLower = new Map(choices.map((choice) => [choice.toLowerCase(), choice]));
  const meant = Array.from(word.toLowerCase());
  let best: { score: number; choice: string } | undefined;
  for (const choice of byLower.keys()) {
    const score = likeness(Array.from(choice), meant);
    if (score < 0.6) continue;
    if (!best || score > best.score || (score === best.score && choice > best.choice)) {
      best = { score, choice };
    }
  }
  return best && byLower.get(best.choice);
}

function likeness(a: readonly string[], b: readonly string[]): number {
  const both = a.length + b.length;
  if (both === 0) return 1;
  if ((2 * Math.min(a.length, b.length)) / both < 0.6) return 0;
  return (2 * matches(a, b)) / both;
}

/** How many letters lie in the longest block that both have, and in those on either side of it. */
function matches(a: readonly string[], b: readonly string[]): number {
  let [size, atA, atB] = [0, 0, 0];
  let before: number[] = [];
  a.forEach((letter, i) => {
    const now: number[] = [];
    b.forEach((other, j) => {
      if (other !== letter) return;
      const length = (before[j - 1] ?? 0) + 1;
      now[j] = length;
      if (length > size) [size, atA, atB] = [length, i - length + 1, j - length + 1];
    });
    before = now;
  });
  if (size === 0) return 0;
  return (
    matches(a.slice(0, atA), b.slice(0, atB)) +
    size +
    matches(a.slice(atA + size), b.slice(atB + size))
  );
}
