/** The declarations of all keys, as `./just types` writes them from `nacreous/spec/`. */

import tables from "./declared.json";
import type { Kind } from "./types";

/** What a JSON Schema says of a value. Bounds beyond 2^53 are texts. */
export interface Node {
  readonly type?: "string" | "number" | "integer" | "array";
  readonly $ref?: string;
  readonly anyOf?: readonly Node[];
  readonly oneOf?: readonly Node[];
  readonly enum?: readonly string[];
  readonly pattern?: string;
  readonly minLength?: number;
  readonly maxLength?: number;
  readonly minimum?: number | string;
  readonly exclusiveMinimum?: number | string;
  readonly maximum?: number | string;
  readonly exclusiveMaximum?: number | string;
  readonly items?: Node;
  readonly prefixItems?: readonly Node[];
  readonly minItems?: number;
  readonly maxItems?: number;
}

export interface Key extends Node {
  readonly meaning: string;
  readonly allowed?: string;
  readonly unit?: string;
  readonly model?: "transport" | "illuminant";
  readonly default?: unknown;
  readonly examples?: readonly string[];
  /** Whether it may be without a value, which the renderer then finds. */
  readonly open?: boolean;
  /** The endings of texts that name a file. */
  readonly files?: readonly string[];
  /** The functions in Python that look at the value too; `rules.ts` has the same. */
  readonly checks?: readonly string[];
}

export interface Declared {
  readonly keys: Readonly<Record<string, Key>>;
  /** Whether the class has `contradictions()`; `rules.ts` has the same. */
  readonly ruled: boolean;
}

export const TABLES: Readonly<Record<string, Declared>> = tables as unknown as Record<
  string,
  Declared
>;

export const ROOTS: Readonly<Record<Kind, string>> = { pearl: "Pearl", scene: "Scene" };

export function declared(name: string): Declared {
  const found = TABLES[name];
  if (!found) throw new Error(`no table ${name} is declared`);
  return found;
}

export function keyOf(table: string, name: string): Key | undefined {
  const { keys } = declared(table);
  return Object.hasOwn(keys, name) ? keys[name] : undefined;
}

/** The class that a node refers to. */
export function tableOf(node: Node): string | undefined {
  return node.$ref?.slice("#/$defs/".length);
}

/** The kinds of value that a node allows, one by one. */
export function alternatives(node: Node): readonly Node[] {
  const inner = node.oneOf ?? node.anyOf;
  return inner ? inner.flatMap(alternatives) : [node];
}

/** Whether it is a list of any length, and not a pair or a triple. */
export function isList(node: Node): boolean {
  return alternatives(node).some((kind) => kind.items !== undefined);
}

/** The tables that a key holds: one, several to choose from, those of a list, or none. */
export function tablesIn(node: Node): readonly string[] {
  return alternatives(node).flatMap((kind) => {
    const table = tableOf(kind);
    if (table) return [table];
    return kind.items ? tablesIn(kind.items) : [];
  });
}

export interface Placed {
  readonly path: string;
  readonly key: Key;
}

/** All keys below a table, tables and what they hold, in the order of the file. */
export function everyKey(table: string, prefix = ""): readonly Placed[] {
  return Object.entries(declared(table).keys).flatMap(([name, key]) => {
    const path = prefix + name;
    const step = isList(key) ? "0." : "";
    const inner = tablesIn(key).flatMap((one) => everyKey(one, `${path}.${step}`));
    return [{ path, key }, ...inner];
  });
}
