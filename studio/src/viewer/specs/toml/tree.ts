/** The tables of a TOML text while it is read, and which of them are closed. */

import type { Table, Value } from "../value";

export type Path = readonly string[];

/** Frozen: of an inline table or list. Explicit: opened by a header, and by no other one. */
export type Flag = "frozen" | "explicit";

interface Marks {
  readonly own: Set<Flag>;
  readonly below: Set<Flag>;
  readonly nested: Map<string, Marks>;
}

export class Flags {
  private readonly marks = new Map<string, Marks>();
  private readonly pending: { readonly path: Path; readonly flag: Flag }[] = [];

  /** To be set when the next header is read. */
  later(path: Path, flag: Flag): void {
    this.pending.push({ path, flag });
  }

  settle(): void {
    for (const { path, flag } of this.pending.splice(0)) this.set(path, flag, false);
  }

  clear(path: Path): void {
    let level: Map<string, Marks> | undefined = this.marks;
    for (const part of path.slice(0, -1)) level = level?.get(part)?.nested;
    level?.delete(path.at(-1) ?? "");
  }

  set(path: Path, flag: Flag, withAllBelow: boolean): void {
    let level = this.marks;
    path.forEach((part, depth) => {
      let found = level.get(part);
      if (!found) {
        found = { own: new Set(), below: new Set(), nested: new Map() };
        level.set(part, found);
      }
      if (depth === path.length - 1) (withAllBelow ? found.below : found.own).add(flag);
      level = found.nested;
    });
  }

  has(path: Path, flag: Flag): boolean {
    let level = this.marks;
    for (const [depth, part] of path.entries()) {
      const found = level.get(part);
      if (!found) return false;
      if (found.below.has(flag)) return true;
      if (depth === path.length - 1) return found.own.has(flag);
      level = found.nested;
    }
    return false;
  }
}

/** The table at a path, made where there is none; undefined where another value stands. */
export function nest(root: Table, path: Path, throughLists = true): Table | undefined {
  let table: Table = root;
  for (const part of path) {
    let inner: Value | undefined = table.get(part);
    if (inner === undefined) {
      inner = new Map();
      table.set(part, inner);
    }
    if (throughLists && Array.isArray(inner)) inner = inner.at(-1);
    if (!(inner instanceof Map)) return undefined;
    table = inner;
  }
  return table;
}

/** Another table at the end of the list at a path; false where another value stands. */
export function append(root: Table, path: Path): boolean {
  const table = nest(root, path.slice(0, -1));
  const last = path.at(-1) ?? "";
  const list = table?.get(last);
  if (!table || (list !== undefined && !Array.isArray(list))) return false;
  if (list) list.push(new Map());
  else table.set(last, [new Map()]);
  return true;
}
