/** What is wrong with a value or a key, in the words of `nacreous/spec/complaint.py`. */

import {
  alternatives,
  declared,
  everyKey,
  type Key,
  type Node,
  tableOf,
  tablesIn,
} from "./declared";
import type { Value } from "./value";
import { nearest, shown } from "./words";

/** `_bad_value`; `item`: the declaration of the entry of a list that the value is. */
export function badValue(value: Value, key: Key, item?: Node): string {
  const kinds = alternatives(item ?? key);
  const words = [`is ${shown(value)}`];
  if (!kinds.some((kind) => fits(value, kind))) {
    words.push(`wanted: ${[...new Set(kinds.map(inWords))].join(" or ")}`);
  }
  const isTableOfList = item !== undefined && tablesIn(key).length > 0;
  if (key.allowed !== undefined && !isTableOfList) words.push(`allowed: ${key.allowed}`);
  const choices = [...(key.examples ?? []), ...kinds.flatMap((kind) => kind.enum ?? [])];
  const near = typeof value === "string" ? nearest(value, choices) : undefined;
  if (near !== undefined) words.push(`did you mean "${near}"?`);
  return words.join("; ");
}

export function isMissing(key: Key): string {
  return `is missing; allowed: ${key.allowed ?? "a table of keys"}`;
}

/** `_unknown_key`: of a key that the table does not have, somewhere below `root`. */
export function unknownKey(unknown: string, table: string, root: string): string {
  const here = Object.keys(declared(table).keys);
  const near =
    nearest(unknown, here) ??
    everyKey(root).findLast(({ path }) => path.split(".").at(-1) === unknown)?.path;
  const hint = near === undefined ? `keys here: ${here.join(", ")}` : `did you mean ${near}?`;
  return `is not a key here; ${hint}`;
}

/** `_in_words` */
function inWords(kind: Node): string {
  if (kind.type === "number") return "a number";
  if (kind.type === "integer") return "a whole number";
  if (kind.type === "array") return `a list of ${entries(kind)}`;
  return kind.type === "string" ? "text in quotes" : "a table of keys";
}

/** `_entries` */
function entries(kind: Node): string {
  if (!kind.items) return "numbers";
  if (tableOf(kind.items) !== undefined) return "tables";
  return kind.items.type === "string" ? "texts" : "numbers";
}

/** `_fits`: whether the value is of the right kind at all, so that only its size is wrong. */
function fits(value: Value, kind: Node): boolean {
  if (kind.type === "number") return typeof value === "bigint" || typeof value === "number";
  if (kind.type === "integer") return typeof value === "bigint";
  if (kind.type === "array") return Array.isArray(value);
  if (kind.type === "string") return typeof value === "string";
  return value instanceof Map;
}
