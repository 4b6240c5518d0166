/**
 * TOML 1.0, as Python's tomllib reads it: the same values, and of what is none the same reason at
 * the same place, so that the page and the command line say the same of a file. After tomllib's
 * parser, Copyright (c) 2021 Taneli Hukkinen, MIT licence.
 */

import type { Table, Value } from "../value";
import { checkDepth } from "./depth";
import { lineAndColumn, type Place, quoted, TomlError } from "./error";
import { momentAt } from "./moment";
import { Strings } from "./strings";
import { append, Flags, nest, type Path } from "./tree";

const NUMBER =
  /0(?:x[0-9A-Fa-f](?:_?[0-9A-Fa-f])*|b[01](?:_?[01])*|o[0-7](?:_?[0-7])*)|[+-]?(?:0|[1-9](?:_?[0-9])*)((?:\.[0-9](?:_?[0-9])*)?(?:[eE][+-]?[0-9](?:_?[0-9])*)?)/y;
const SPECIAL = /[+-]?(?:inf|nan)/y;
/** Python reads no longer one. */
const MOST_DIGITS = 4300;

/** The keys of a TOML text; throws a TomlError. */
export function parseToml(text: string): Table {
  checkDepth(text);
  return new Parser(text).document();
}

class Parser extends Strings {
  private readonly root: Table = new Map();
  private readonly flags = new Flags();
  private header: Path = [];

  constructor(private readonly whole: string) {
    super(whole.replaceAll("\r\n", "\n"));
  }

  document(): Table {
    while (this.skip(" \t") !== "") {
      if (this.sign() === "\n") {
        this.at += 1;
        continue;
      }
      this.statement();
      this.skip(" \t");
      this.comment();
      if (this.sign() === "") break;
      if (this.sign() !== "\n") {
        throw this.error("Expected newline or end of document after a statement");
      }
      this.at += 1;
    }
    return this.root;
  }

  protected override error(reason: string): TomlError {
    return new TomlError(`not TOML: ${reason}`, this.place());
  }

  private place(): Place {
    // Of the end, in the text as it was given.
    return this.at >= this.text.length
      ? lineAndColumn(this.whole, this.whole.length)
      : lineAndColumn(this.text, this.at);
  }

  private statement(): void {
    if (this.text.startsWith("[[", this.at)) {
      this.flags.settle();
      this.listHeader();
    } else if (this.sign() === "[") {
      this.flags.settle();
      this.tableHeader();
    } else if (/[A-Za-z0-9_"'-]/.test(this.sign())) {
      this.assignment();
    } else if (this.sign() !== "#") {
      throw this.error("Invalid statement");
    }
  }

  private tableHeader(): void {
    this.at += 1;
    this.skip(" \t");
    const path = this.path();
    if (this.flags.has(path, "explicit") || this.flags.has(path, "frozen")) {
      throw this.error(`Cannot declare ${tuple(path)} twice`);
    }
    this.flags.set(path, "explicit", false);
    if (!nest(this.root, path)) throw this.error("Cannot overwrite a value");
    if (this.sign() !== "]") throw this.error("Expected ']' at the end of a table declaration");
    this.at += 1;
    this.header = path;
  }

  private listHeader(): void {
    this.at += 2;
    this.skip(" \t");
    const path = this.path();
    if (this.flags.has(path, "frozen")) {
      throw this.error(`Cannot mutate immutable namespace ${tuple(path)}`);
    }
    this.flags.clear(path);
    this.flags.set(path, "explicit", false);
    if (!append(this.root, path)) throw this.error("Cannot overwrite a value");
    if (!this.text.startsWith("]]", this.at)) {
      throw this.error("Expected ']]' at the end of an array declaration");
    }
    this.at += 2;
    this.header = path;
  }

  private assignment(): void {
    const [key, value] = this.pair();
    const path = [...this.header, ...key];
    const above = path.slice(0, -1);
    const last = path.at(-1) ?? "";
    for (let length = 1; length < key.length; length += 1) {
      const between = path.slice(0, this.header.length + length);
      if (this.flags.has(between, "explicit")) {
        throw this.error(`Cannot redefine namespace ${tuple(between)}`);
      }
      this.flags.later(between, "explicit");
    }
    if (this.flags.has(above, "frozen")) {
      throw this.error(`Cannot mutate immutable namespace ${tuple(above)}`);
    }
    const table = nest(this.root, above);
    if (!table || table.has(last)) throw this.error("Cannot overwrite a value");
    if (holds(value)) this.flags.set(path, "frozen", true);
    table.set(last, value);
  }

  private pair(): [Path, Value] {
    const key = this.path();
    if (this.sign() !== "=") throw this.error("Expected '=' after a key in a key/value pair");
    this.at += 1;
    this.skip(" \t");
    return [key, this.value()];
  }

  private path(): Path {
    const path = [this.keyPart()];
    while (this.skip(" \t") === ".") {
      this.at += 1;
      this.skip(" \t");
      path.push(this.keyPart());
    }
    return path;
  }

  private value(): Value {
    const sign = this.sign();
    if (sign === '"' || sign === "'") return this.anyString();
    for (const word of ["true", "false"]) {
      if (!this.text.startsWith(word, this.at)) continue;
      this.at += word.length;
      return word === "true";
    }
    if (sign === "[") return this.list();
    if (sign === "{") return this.inlineTable();
    const moment = momentAt(this.text, this.at);
    if (moment === "invalid") throw this.error("Invalid date or datetime");
    if (moment) {
      this.at = moment.end;
      return moment.moment;
    }
    return this.number();
  }

  private number(): Value {
    const found = this.match(NUMBER);
    if (found) {
      const text = found[0].replaceAll("_", "");
      if (found[1]) return Number(text);
      if (/^[+-]?\d+$/.test(text) && text.replace(/^[+-]/, "").length > MOST_DIGITS) {
        throw new TomlError("holds a number too long to be read");
      }
      const size = BigInt(text.replace(/^[+-]/, ""));
      return text.startsWith("-") ? -size : size;
    }
    const special = this.match(SPECIAL)?.[0];
    if (special === undefined) throw this.error("Invalid value");
    if (special.endsWith("nan")) return Number.NaN;
    return special.startsWith("-") ? Number.NEGATIVE_INFINITY : Number.POSITIVE_INFINITY;
  }

  private match(pattern: RegExp): RegExpExecArray | null {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    if (found) this.at = pattern.lastIndex;
    return found;
  }

  private list(): Value[] {
    const list: Value[] = [];
    this.at += 1;
    this.skipLines();
    while (this.sign() !== "]") {
      list.push(this.value());
      this.skipLines();
      if (this.sign() === "]") break;
      if (this.sign() !== ",") throw this.error("Unclosed array");
      this.at += 1;
      this.skipLines();
    }
    this.at += 1;
    return list;
  }

  private skipLines(): void {
    let before = -1;
    while (this.at !== before) {
      before = this.at;
      this.skip(" \t\n");
      this.comment();
    }
  }

  private inlineTable(): Table {
    const table: Table = new Map();
    const flags = new Flags();
    this.at += 1;
    if (this.skip(" \t") === "}") {
      this.at += 1;
      return table;
    }
    for (;;) {
      const [key, value] = this.pair();
      this.insert(table, flags, key, value);
      const sign = this.skip(" \t");
      if (sign !== "}" && sign !== ",") throw this.error("Unclosed inline table");
      this.at += 1;
      if (sign === "}") return table;
      if (holds(value)) flags.set(key, "frozen", true);
      this.skip(" \t");
    }
  }

  private insert(table: Table, flags: Flags, key: Path, value: Value): void {
    if (flags.has(key, "frozen")) {
      throw this.error(`Cannot mutate immutable namespace ${tuple(key)}`);
    }
    const inner = nest(table, key.slice(0, -1), false);
    if (!inner) throw this.error("Cannot overwrite a value");
    const last = key.at(-1) ?? "";
    if (inner.has(last)) throw this.error(`Duplicate inline table key ${quoted(last)}`);
    inner.set(last, value);
  }
}

function holds(value: Value): boolean {
  return Array.isArray(value) || value instanceof Map;
}

/** A path as Python shows a tuple. */
function tuple(path: Path): string {
  return path.length === 1 ? `(${quoted(path[0] ?? "")},)` : `(${path.map(quoted).join(", ")})`;
}
