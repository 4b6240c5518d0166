/** Values of a spec by their path, such as "nacre.harvest" or "lamps.0.azimuth_deg". */

/** What stands there; undefined where there is no such key. */
export function valueAt(spec: unknown, path: string): unknown {
  let found = spec;
  for (const key of path.split(".")) {
    if (typeof found !== "object" || found === null) return undefined;
    found = (found as Record<string, unknown>)[key];
  }
  return found;
}

/** The spec with another value there; whatever is beside the path is shared, nothing is changed. */
export function withValue<T>(spec: T, path: string, value: unknown): T {
  const [key, ...rest] = path.split(".");
  if (key === undefined || key === "") return value as T;
  if (Array.isArray(spec)) {
    return spec.map((one: unknown, i) =>
      i === Number(key) ? withValue(one, rest.join("."), value) : one,
    ) as T;
  }
  const before = (spec ?? {}) as Record<string, unknown>;
  return { ...before, [key]: withValue(before[key], rest.join("."), value) } as T;
}

/** A path without the numbers of lists: the key that was declared. */
export function declared(path: string): string {
  return path.replace(/\[\]|\.\d+/g, "");
}

export interface Change {
  readonly path: string;
  readonly from: unknown;
  readonly to: unknown;
}

/** The single values in which a spec differs from another. */
export function changes(from: unknown, to: unknown, before = ""): Change[] {
  if (Object.is(from, to)) return [];
  const both = [from, to].every((one) => typeof one === "object" && one !== null);
  const numbers = (one: unknown) => Array.isArray(one) && typeof one[0] !== "object";
  if (!both || numbers(from) || numbers(to) || Array.isArray(from) !== Array.isArray(to)) {
    const same = JSON.stringify(plain(from)) === JSON.stringify(plain(to));
    return same ? [] : [{ path: before, from, to }];
  }
  const [a, b] = [from, to] as [Record<string, unknown>, Record<string, unknown>];
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...keys].flatMap((key) =>
    changes(a[key], b[key], before === "" ? key : `${before}.${key}`),
  );
}

/** Whole numbers beyond 2^53 are no numbers of JSON. */
function plain(value: unknown): unknown {
  if (typeof value === "bigint") return value.toString();
  return value === undefined ? null : value;
}
