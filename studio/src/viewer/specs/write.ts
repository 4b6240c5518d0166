/** Specs as TOML and as JSON: numbers as the types of their keys, however JavaScript holds them. */

import {
  alternatives,
  type Declared,
  declared,
  type Key,
  type Node,
  ROOTS,
  tableOf,
} from "./declared";
import { json, repr } from "./number";
import type { Kind, Specs } from "./types";

/** How one format writes what the other writes otherwise. */
interface Format {
  readonly number: (size: number) => string;
  readonly text: (text: string) => string;
  readonly table: (entries: readonly (readonly [string, string])[]) => string;
  readonly comma: string;
}

const TOML: Format = {
  number: repr,
  text: (text) => JSON.stringify(text).replaceAll("\x7f", "\\u007f"),
  table: (entries) => `{ ${entries.map(([key, value]) => `${key} = ${value}`).join(", ")} }`,
  comma: ", ",
};

const JSON_TEXT: Format = {
  number: json,
  text: (text) => JSON.stringify(text),
  table: (entries) =>
    `{${entries.map(([key, value]) => `${JSON.stringify(key)}:${value}`).join(",")}}`,
  comma: ",",
};

type Plain = Readonly<Record<string, unknown>>;

/** The complete file, as Python's `to_toml` writes it. */
export function toToml<K extends Kind>(kind: K, spec: Specs[K]): string {
  const root = declared(ROOTS[kind]);
  const keys = Object.entries(spec).filter(([, value]) => value !== null);
  const blocks = [
    keys
      .filter(([, value]) => !heads(value))
      .map(([key, value]) => `${key} = ${written(value, root.keys[key], TOML)}\n`)
      .join(""),
  ];
  for (const [key, value] of keys) {
    if (!heads(value)) continue;
    const table = tablesOf(root, key, value);
    if (Array.isArray(value)) {
      for (const entry of value) blocks.push(`[[${key}]]\n${lines(entry as Plain, table)}`);
    } else {
      blocks.push(`[${key}]\n${lines(value as Plain, table)}`);
    }
  }
  return blocks.filter((block) => block !== "").join("\n");
}

/** A spec as pydantic writes it: compact, every key, null where it is open. */
export function specJson<K extends Kind>(kind: K, spec: Specs[K]): string {
  return tableText(spec, declared(ROOTS[kind]), JSON_TEXT);
}

/** Whether the value stands below a heading of its own. */
function heads(value: unknown): boolean {
  return Array.isArray(value)
    ? value.length > 0 && typeof value[0] === "object"
    : typeof value === "object";
}

function lines(table: Plain, shape: Declared): string {
  return Object.entries(table)
    .filter(([, value]) => value !== null)
    .map(([key, value]) => `${key} = ${written(value, shape.keys[key], TOML)}\n`)
    .join("");
}

function tablesOf(owner: Declared, key: string, value: unknown): Declared {
  return shapeOf(value, owner.keys[key]) ?? owner;
}

/** The declaration of a table, or of those in a list. */
function shapeOf(value: unknown, key: Key | Node | undefined): Declared | undefined {
  const kinds = key ? alternatives(key) : [];
  const names = kinds
    .map((kind) => tableOf(kind.items ?? kind))
    .filter((name) => name !== undefined);
  const isListed = typeof value === "object" && value !== null && "thickness_nm" in value;
  const name = isListed ? names.find((one) => one === "Layers") : names[0];
  return name === undefined ? undefined : declared(name);
}

function tableText(table: object, shape: Declared, format: Format): string {
  return format.table(
    Object.entries(table).map(([key, value]) => [key, written(value, shape.keys[key], format)]),
  );
}

function written(value: unknown, key: Key | Node | undefined, format: Format): string {
  if (value === null) return "null";
  if (typeof value === "string") return format.text(value);
  if (typeof value === "bigint") return value.toString();
  if (typeof value === "number") {
    const isWhole = key !== undefined && alternatives(key).some((kind) => kind.type === "integer");
    return isWhole ? String(value) : format.number(value);
  }
  if (Array.isArray(value)) {
    const list = key && alternatives(key).find((kind) => kind.items);
    const item = list?.items;
    return `[${value.map((one) => written(one, item, format)).join(format.comma)}]`;
  }
  const shape = shapeOf(value, key);
  if (typeof value !== "object" || !shape) throw new TypeError(`no spec holds a ${typeof value}`);
  return tableText(value, shape, format);
}
