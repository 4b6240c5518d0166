/**
 * Values as a TOML file holds them: unlike JavaScript's, whole numbers and others differ, tables keep
 * the order of their keys, and there are days.
 */

/** A day, or a time, as Python's `str` writes it. */
export class Moment {
  constructor(
    readonly text: string,
    /** Whether it is a day alone, without a time. */
    readonly isDay: boolean,
  ) {}
}

export type Table = Map<string, Value>;

/** A bigint is a whole number, a number any other. */
export type Value = null | boolean | string | bigint | number | Moment | Value[] | Table;

/**
 * What JavaScript has, such as a spec or what JSON says, as a file's value: a number without a
 * fraction is a whole one there.
 */
export function valueOf(given: unknown): Value {
  if (given === undefined || given === null) return null;
  if (typeof given === "number") return isWhole(given) ? BigInt(given) : given;
  if (typeof given === "boolean" || typeof given === "string" || typeof given === "bigint") {
    return given;
  }
  if (given instanceof Moment) return given;
  if (Array.isArray(given)) return given.map(valueOf);
  if (given instanceof Map) return new Map(given as Table);
  if (typeof given !== "object") return null;
  return new Map(
    Object.entries(given)
      .filter(([, value]) => value !== undefined)
      .map(([key, value]) => [key, valueOf(value)]),
  );
}

function isWhole(given: number): boolean {
  return Number.isInteger(given) && !Object.is(given, -0);
}
