/** Reading pearl and scene files: what they hold, in full, or the command line's complaints. */

import { Check, names, type Problem } from "./check";
import { declared, keyOf, ROOTS, tablesIn } from "./declared";
import { bytesToText, tomlTable } from "./document";
import { ownKeys } from "./model";
import type { Complaint, Kind, Pearl, Read, Scene, Specs } from "./types";
import { type Table, type Value, valueOf } from "./value";
import { label, shown } from "./words";

/** A list of 5000 bad numbers is one mistake, not 5000. */
const MOST_LINES = 20;
const NO_FILES: ReadonlySet<string> = new Set();

export type AnySpec =
  | { readonly kind: "pearl"; readonly spec: Pearl }
  | { readonly kind: "scene"; readonly spec: Scene };

/**
 * The spec of a file's keys. `file` names it in complaints; `files` are the names of those dropped
 * onto the page, for a page has no others.
 */
export function read<K extends Kind>(
  kind: K,
  values: unknown,
  file: string,
  files = NO_FILES,
): Read<Specs[K]> {
  const where = label(file);
  const table = valueOf(values);
  if (!(table instanceof Map)) {
    return refused(`${where}: is ${shown(table)}; wanted: a table of keys`);
  }
  const other: Kind = kind === "pearl" ? "scene" : "pearl";
  if (knownKeys(kind, table) === 0 && knownKeys(other, table) > 0) {
    return refused(`${where}: is a ${other} file; wanted: a ${kind} file`);
  }
  const root = ROOTS[kind];
  const check = new Check(root, files);
  const made = check.table(root, withPlainPaths(root, table), "");
  if (check.problems.length > 0) {
    return { ok: false, complaints: complaints(check.problems, where) };
  }
  const own = kind === "pearl" ? ownKeys(made, root, (made as Pearl).model) : made;
  return { ok: true, value: own as Specs[K] };
}

/** The spec of a file's text. */
export function fromToml<K extends Kind>(
  kind: K,
  text: string,
  file: string,
  files = NO_FILES,
): Read<Specs[K]> {
  const table = tomlTable(text, label(file));
  return table.ok ? read(kind, table.value, file, files) : table;
}

/** The spec of a file's bytes. */
export function fromBytes<K extends Kind>(
  kind: K,
  bytes: Uint8Array,
  file: string,
  files = NO_FILES,
): Read<Specs[K]> {
  const text = bytesToText(bytes, label(file));
  return text.ok ? fromToml(kind, text.value, file, files) : text;
}

/** A file of either kind, whose outermost keys show which: `nacreous/spec/load.py`. */
export function open(bytes: Uint8Array, file: string, files = NO_FILES): Read<AnySpec> {
  const where = label(file);
  const text = bytesToText(bytes, where);
  if (!text.ok) return text;
  const table = tomlTable(text.value, where);
  if (!table.ok) return table;
  const [asPearl, asScene] = [knownKeys("pearl", table.value), knownKeys("scene", table.value)];
  if (asPearl === asScene) {
    return refused(
      `${where}: the keys show neither a pearl nor a scene; wanted: a key such as nacre, ` +
        "diameter_mm or depth for a pearl, camera, lamps or table for a scene",
    );
  }
  if (asPearl > asScene) {
    const pearl = read("pearl", table.value, file, files);
    return pearl.ok ? { ok: true, value: { kind: "pearl", spec: pearl.value } } : pearl;
  }
  const scene = read("scene", table.value, file, files);
  return scene.ok ? { ok: true, value: { kind: "scene", spec: scene.value } } : scene;
}

export function refused(text: string): { ok: false; complaints: Complaint[] } {
  return { ok: false, complaints: [{ path: "", text }] };
}

/** specfile.py `known_keys`: outermost keys of this kind, the name that both have aside. */
function knownKeys(kind: Kind, table: Table): number {
  const isKnown = (key: string) => key !== "name" && keyOf(ROOTS[kind], key);
  return [...table.keys()].filter(isKnown).length;
}

/** complaint.py `complaints`: one line for each problem. */
function complaints(problems: readonly Problem[], where: string): Complaint[] {
  const verdicts = new Map<string, string>();
  for (const { path, verdict } of problems) {
    if (!verdicts.has(path)) verdicts.set(path, verdict);
  }
  // A list without one good entry also counts as empty: its entries say enough.
  const above = new Set(
    [...verdicts.keys()].map((path) => path.slice(0, Math.max(path.lastIndexOf("."), 0))),
  );
  const found = [...verdicts]
    .filter(([path]) => !above.has(path))
    .map(([path, verdict]) => ({ path, verdict, text: `${where}: ${path} ${verdict}` }));
  if (found.length <= MOST_LINES) return found;
  const more = { path: "", text: `... and ${found.length - MOST_LINES} more problems` };
  return [...found.slice(0, MOST_LINES), more];
}

/** specfile.py `move_paths`, of a file that lies in no folder: paths without needless parts. */
function withPlainPaths(name: string, table: Table): Table {
  const moved = new Map(table);
  for (const [key, declaration] of Object.entries(declared(name).keys)) {
    const value = moved.get(key);
    if (value === undefined) continue;
    const plain = (one: Value): Value => {
      if (typeof one === "string" && names(declaration, one)) return plainPath(one);
      const inner = tablesIn(declaration);
      return one instanceof Map
        ? inner.reduce((kept, each) => withPlainPaths(each, kept), one)
        : one;
    };
    moved.set(key, Array.isArray(value) ? value.map(plain) : plain(value));
  }
  return moved;
}

/** A path as Python's `Path` writes it. */
function plainPath(path: string): string {
  const root = /^\/\/(?!\/)/.test(path) ? "//" : path.startsWith("/") ? "/" : "";
  const parts = path.split("/").filter((part) => part !== "" && part !== ".");
  return root + parts.join("/");
}
