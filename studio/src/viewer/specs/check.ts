/** Tables against their declaration: complete ones, or everything that is wrong with them. */

import { passed, REFUSED } from "./convert";
import { alternatives, declared, type Key, keyOf, type Node, tableOf } from "./declared";
import { NACRES } from "./presets";
import { RULES } from "./rules";
import { type Table, type Value, valueOf } from "./value";
import { badValue, isMissing, unknownKey } from "./verdict";
import { shown, shownKey } from "./words";

export interface Problem {
  readonly path: string;
  readonly verdict: string;
}

/** A file that is checked. */
export class Check {
  readonly problems: Problem[] = [];
  readonly given = new Map<object, ReadonlySet<string>>();

  constructor(
    private readonly root: string,
    /** The names of files that are at hand. */
    private readonly files: ReadonlySet<string>,
  ) {}

  /** The table in full; of no use where problems were found. */
  table(name: string, values: Table, path: string): object {
    const before = this.problems.length;
    const filled = this.filled(name, values, path);
    if (!filled) return {};
    const made: Record<string, unknown> = {};
    for (const [key, declaration] of Object.entries(declared(name).keys)) {
      made[key] = this.key(name, key, declaration, filled, prefixed(path, key));
    }
    for (const key of filled.keys()) {
      if (!keyOf(name, key)) {
        this.complain(prefixed(path, shownKey(key)), unknownKey(key, name, this.root));
      }
    }
    this.given.set(made, new Set(filled.keys()));
    if (this.problems.length === before) this.contradictions(name, made, path);
    return made;
  }

  private complain(path: string, verdict: string): typeof REFUSED {
    this.problems.push({ path, verdict });
    return REFUSED;
  }

  private contradictions(name: string, made: object, path: string): void {
    for (const { key, verdict, other } of RULES[name]?.(made as never, this.given) ?? []) {
      const said = verdict.replaceAll("{other}", prefixed(path, other ?? ""));
      this.complain(prefixed(path, key), said);
    }
  }

  /** What comes before the keys are looked at; undefined where there is no more to look at. */
  private filled(name: string, values: Table, path: string): Table | undefined {
    if (name === "Growth") return onPreset(values);
    const grown = name === "Layers" ? grownKeys(values) : [];
    for (const key of grown) {
      const other = prefixed(path, "thickness_nm");
      this.complain(
        prefixed(path, key),
        `cannot stand beside ${other}: layers are either listed or grown`,
      );
    }
    return grown.length > 0 ? undefined : values;
  }

  private key(table: string, name: string, key: Key, values: Table, path: string): unknown {
    const value = values.get(name);
    if (value === undefined) return this.leftOut(key, path);
    if (value === null && key.open) return null;
    const inner = chosenTable(key, value);
    if (inner !== undefined) {
      return value instanceof Map
        ? this.table(inner, value, path)
        : this.complain(path, badValue(value, key));
    }
    const list = alternatives(key).find((kind) => kind.items);
    if (list?.items && Array.isArray(value)) {
      return this.list(table, key, list, list.items, value, path);
    }
    return this.single(table, key, key, value, path);
  }

  private leftOut(key: Key, path: string): unknown {
    if (key.default !== undefined) return key.default;
    if (key.open) return null;
    const inner = chosenTable(key, new Map());
    return inner === undefined
      ? this.complain(path, isMissing(key))
      : this.table(inner, new Map(), path);
  }

  private list(
    table: string,
    key: Key,
    list: Node,
    item: Node,
    values: readonly Value[],
    path: string,
  ): unknown {
    const before = this.problems.length;
    const inner = tableOf(item);
    const made: unknown[] = [];
    for (const [place, value] of values.entries()) {
      const soFar = this.problems.length;
      const at = `${path}.${place}`;
      const one =
        inner !== undefined && value instanceof Map
          ? this.table(inner, value, at)
          : this.single(table, key, item, value, at);
      if (this.problems.length === soFar) made.push(one);
      if (made.length > (list.maxItems ?? Number.POSITIVE_INFINITY)) {
        this.problems.length = before; // the list is told as too long, and nothing of its items
        return this.complain(path, badValue([...values], key));
      }
    }
    if (this.problems.length === before && made.length < (list.minItems ?? 0)) {
      return this.complain(path, badValue([...values], key));
    }
    return made;
  }

  private single(table: string, key: Key, node: Node, value: Value, path: string): unknown {
    const isItem = node !== key;
    const found = passed(key, node, value, table);
    if (found === REFUSED)
      return this.complain(path, badValue(value, key, isItem ? node : undefined));
    if (typeof found === "string" && names(key, found)) return this.file(key, found, path);
    return found;
  }

  /** A file that the page has; a pearl's own file in a row it has not, for it shows one pearl. */
  private file(key: Key, name: string, path: string): unknown {
    if (key.files?.includes(".toml")) {
      return this.complain(path, `is ${shown(name)}; allowed on this page: pearl presets and "*"`);
    }
    if (this.files.has(name)) return name;
    return this.complain(
      path,
      `is ${shown(name)}, which this page does not have; wanted: a file that was dropped onto it`,
    );
  }
}

function prefixed(path: string, key: string): string {
  return path === "" ? key : `${path}.${key}`;
}

export function names(key: Key, text: string): boolean {
  return (key.files ?? []).some((ending) => text.toLowerCase().endsWith(ending));
}

/**
 * The class of a table, where the value is to be one: pearl.py `_grown_or_listed`, medium.py
 * `_index_or_uniaxial`.
 */
function chosenTable(key: Key, value: Value): string | undefined {
  const kinds = alternatives(key);
  const tables = kinds.map(tableOf);
  if (tables.includes("Layers")) {
    return value instanceof Map && value.has("thickness_nm") ? "Layers" : "Growth";
  }
  if (kinds.length === 1) return tables[0];
  return value instanceof Map ? tables.find((name) => name !== undefined) : undefined;
}

/** growth.py `Growth._on_preset`: the preset's values first, the given ones over them. */
function onPreset(values: Table): Table {
  const name = values.get("preset");
  const preset = typeof name === "string" ? NACRES.get(name) : undefined;
  return preset ? new Map([...(valueOf(preset) as Table), ...values]) : values;
}

/** nacre.py `Layers._not_grown`: keys of growth beside the list, which would be ignored. */
function grownKeys(values: Table): string[] {
  const isGrown = (name: string) => keyOf("Growth", name) && !keyOf("Layers", name);
  return [...values.keys()].filter(isGrown);
}
