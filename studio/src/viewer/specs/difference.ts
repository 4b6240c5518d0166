/** What differs between two tables, as JSON, and a table again from that and the other one. */

/** A table in place of another, not laid over it; and a whole number that JSON would round. */
const WHOLE = "=";
const NUMBER = "#";

type Plain = Readonly<Record<string, unknown>>;

/** What `table` has otherwise than `base`, key by key; of tables with other keys all of it. */
export function difference(table: object, base: object): Plain {
  const other = base as Plain;
  const found: Record<string, unknown> = {};
  for (const [key, value] of Object.entries(table)) {
    const beside = other[key];
    if (isTable(value) && isTable(beside) && sameKeys(value, beside)) {
      const inner = difference(value, beside);
      if (Object.keys(inner).length > 0) found[key] = inner;
    } else if (!same(value, beside)) {
      found[key] = isTable(value) ? { [WHOLE]: plain(value) } : plain(value);
    }
  }
  return found;
}

/** Tables in each other, far more than any spec has: so that no link exhausts the stack. */
const DEEPEST = 16;

/** `base` with what differs laid over it; nothing of it is checked here but its depth. */
export function laidOver(base: unknown, found: unknown, depth = 0): unknown {
  if (depth > DEEPEST) return null;
  const below = depth + 1;
  if (Array.isArray(found)) return found.map((one) => laidOver({}, one, below));
  if (!isTable(found)) return found;
  if (Object.hasOwn(found, WHOLE)) return laidOver({}, found[WHOLE], below);
  const digits = found[NUMBER];
  if (typeof digits === "string" && /^\d{1,30}$/.test(digits)) return BigInt(digits);
  const made = new Map(isTable(base) ? Object.entries(base) : []);
  for (const [key, value] of Object.entries(found))
    made.set(key, laidOver(made.get(key), value, below));
  return Object.fromEntries(made);
}

function plain(value: unknown): unknown {
  if (typeof value === "bigint") return { [NUMBER]: value.toString() };
  if (Array.isArray(value)) return value.map(plain);
  if (!isTable(value)) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, plain(one)]));
}

function isTable(value: unknown): value is Plain {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function sameKeys(one: Plain, other: Plain): boolean {
  return Object.keys(one).join() === Object.keys(other).join();
}

function same(one: unknown, other: unknown): boolean {
  return one === other || JSON.stringify(plain(one)) === JSON.stringify(plain(other));
}
