/** Single values against their declaration: of the right type and within range, or refused. */

import { AFTER, BEFORE } from "./checks";
import { type Key, type Node, tableOf } from "./declared";
import { Moment, type Value } from "./value";
import { letters } from "./words";

/** What a value that is refused becomes. */
export const REFUSED = Symbol("refused");

export type Converted = string | number | bigint | readonly (string | number)[] | typeof REFUSED;

/** A value that is no table and no list of any length. */
export function convert(node: Node, value: Value): Converted {
  const either = node.anyOf ?? node.oneOf;
  if (either) {
    for (const one of either.filter((kind) => tableOf(kind) === undefined)) {
      const found = convert(one, value);
      if (found !== REFUSED) return found;
    }
    return REFUSED;
  }
  if (node.type === "number") return number(node, value);
  if (node.type === "integer") return whole(node, value);
  if (node.type === "string") return text(node, value);
  if (node.prefixItems && Array.isArray(value)) return several(node.prefixItems, value);
  return REFUSED;
}

function number(node: Node, value: Value): number | typeof REFUSED {
  if (typeof value !== "bigint" && typeof value !== "number") return REFUSED;
  const size = Number(value);
  return Number.isFinite(size) && within(node, size, Number) ? size : REFUSED;
}

/** As a number where every browser's number holds it. */
function whole(node: Node, value: Value): number | bigint | typeof REFUSED {
  if (typeof value !== "bigint" || !within(node, value, BigInt)) return REFUSED;
  return Number.isSafeInteger(Number(value)) ? Number(value) : value;
}

function within<T extends number | bigint>(
  node: Node,
  size: T,
  bound: (given: number | string) => T,
): boolean {
  const { minimum, exclusiveMinimum, maximum, exclusiveMaximum } = node;
  return (
    (minimum === undefined || size >= bound(minimum)) &&
    (exclusiveMinimum === undefined || size > bound(exclusiveMinimum)) &&
    (maximum === undefined || size <= bound(maximum)) &&
    (exclusiveMaximum === undefined || size < bound(exclusiveMaximum))
  );
}

function text(node: Node, value: Value): string | typeof REFUSED {
  if (typeof value !== "string") return REFUSED;
  if (node.enum && !node.enum.includes(value)) return REFUSED;
  const length = letters(value);
  if (length < (node.minLength ?? 0) || length > (node.maxLength ?? length)) return REFUSED;
  return node.pattern === undefined || pattern(node.pattern).test(value) ? value : REFUSED;
}

const PATTERNS = new Map<string, RegExp>();

/** A pattern as Rust's expressions mean it, in which a point is everything but the end of a line. */
function pattern(source: string): RegExp {
  let made = PATTERNS.get(source);
  if (!made) {
    made = new RegExp(source.replaceAll(".+", "[^\\n]+"), "u");
    PATTERNS.set(source, made);
  }
  return made;
}

function several(nodes: readonly Node[], values: readonly Value[]): Converted {
  if (values.length !== nodes.length) return REFUSED;
  const made: number[] = [];
  for (const [place, node] of nodes.entries()) {
    const found = number(node, values[place] ?? null);
    if (found === REFUSED) return REFUSED;
    made.push(found);
  }
  return made;
}

/** A value of a key, or of an item of its list, past the key's functions in Python too. */
export function passed(key: Key, node: Node, value: Value, table: string): Converted {
  const checks = key.checks ?? [];
  const given = checks.reduce((kept, name) => BEFORE[name]?.(kept) ?? kept, value);
  let found = convert(node, given instanceof Moment ? value : given);
  for (const name of checks) {
    if (typeof found === "string" && AFTER[name]) found = AFTER[name](found, table) ?? REFUSED;
  }
  return found;
}
