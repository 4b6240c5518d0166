/** The keys as knobs need them. */

import { alternatives, everyKey, type Key, type Placed, ROOTS, tablesIn } from "./declared";
import type { Declaration, Kind } from "./types";

/** Every key of a kind of file that has a value of its own, in the order of the file. */
export function declarations(kind: Kind): readonly Declaration[] {
  const placed = everyKey(ROOTS[kind]);
  // A key of a table that one model alone has is that model's alone.
  const tables = placed.filter(({ key }) => key.model && tablesIn(key).length > 0);
  const found = new Map<string, Declaration>();
  for (const one of placed) {
    if (one.key.allowed === undefined || found.has(one.path)) continue;
    const above = tables.find(({ path }) => one.path.startsWith(`${path}.`));
    found.set(one.path, declaration(one, one.key.model ?? above?.key.model));
  }
  return [...found.values()];
}

function declaration({ path, key }: Placed, model: Key["model"]): Declaration {
  const kinds = alternatives(key);
  const number = kinds.find((one) => one.type === "number" || one.type === "integer") ?? {};
  const choices = choicesOf(key);
  return {
    path,
    unit: key.unit ?? "",
    least: bound(number.minimum ?? number.exclusiveMinimum),
    most: bound(number.maximum ?? number.exclusiveMaximum),
    leastExcluded: number.exclusiveMinimum !== undefined,
    mostExcluded: number.exclusiveMaximum !== undefined,
    isWhole: number.type === "integer",
    ...(choices.length > 0 && { choices }),
    default: key.default ?? null,
    ...(model && { model }),
    meaning: key.meaning,
    allowed: key.allowed ?? "",
    isOpen: key.open === true,
    files: key.files ?? [],
  };
}

/** The texts that the key may be, or, of more, those that Python gives as examples. */
function choicesOf(key: Key): readonly string[] {
  const texts = alternatives(key).flatMap((kind) => kind.enum ?? []);
  return texts.length > 0 ? texts : (key.examples ?? []);
}

function bound(given: number | string | undefined): number | null {
  return given === undefined ? null : Number(given);
}
