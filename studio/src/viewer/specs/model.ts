/** The two models of a pearl's light, and which keys belong to one of them: `nacreous/spec/model.py`. */

import { declared, tableOf } from "./declared";
import type { Pearl } from "./types";

export type Model = Pearl["model"];

/** Which keys of each checked table stood in the file. */
export type Given = ReadonlyMap<object, ReadonlySet<string>>;

type Checked = Readonly<Record<string, unknown>>;

/** Keys given that belong to the other model, each with the model that has it. */
export function* strangers(
  table: object,
  name: string,
  model: Model,
  given: Given,
): Generator<{ key: string; model: Model }> {
  for (const [key, declaration] of Object.entries(declared(name).keys)) {
    const value = (table as Checked)[key];
    if (value === null || !given.get(table)?.has(key)) continue;
    const home = declaration.model;
    const isTable = typeof value === "object" && given.has(value as object);
    if (home !== undefined && home !== model) {
      const inside = isTable ? givenKeys(value as object, given) : [];
      for (const inner of inside) yield { key: `${key}.${inner}`, model: home };
      if (inside.length === 0) yield { key, model: home };
    } else if (isTable) {
      const inner = tableOf(declaration);
      if (inner === undefined) continue; // nacre and media, which both models have
      for (const found of strangers(value as object, inner, model, given)) {
        yield { ...found, key: `${key}.${found.key}` };
      }
    }
  }
}

function givenKeys(table: object, given: Given): string[] {
  const known = given.get(table);
  return Object.entries(table)
    .filter(([key, value]) => value !== null && known?.has(key))
    .map(([key]) => key);
}

/** A checked pearl without the keys that belong to the other model. */
export function ownKeys<T extends object>(table: T, name: string, model: Model): T {
  const { keys } = declared(name);
  const kept = Object.entries(table)
    .filter(([key]) => (keys[key]?.model ?? model) === model)
    .map(([key, value]) => {
      const inner = keys[key] && tableOf(keys[key]);
      return [key, inner && value !== null ? ownKeys(value as object, inner, model) : value];
    });
  return Object.fromEntries(kept) as T;
}
