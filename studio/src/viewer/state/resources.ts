/** What the renderer needs of the files that were dropped; the grain of photographs is measured for it. */

import { signal } from "@preact/signals";
import type { Grain } from "nacreous-files";
import type { Resources } from "nacreous-wasm";
import { ask } from "../light/desk";
import type { GrainKeys } from "../light/requests";
import { type Pearl, type Specs, label, recipeJson } from "../specs/spec";
import { type Dropped, namedBy } from "./dropped";

export interface Needed {
  /** What the renderer takes; the same object for the same contents. */
  readonly resources?: Resources;
  /** Whether a photograph's grain is still being measured. */
  readonly waits: boolean;
  /** Why that cannot be. */
  readonly failed: string;
}

const NOTHING: Needed = { waits: false, failed: "" };

/** Grains by photograph and by the keys that measure them; of one that cannot be measured, why not. */
const grains = signal<ReadonlyMap<string, Grain | string>>(new Map());
const asked = new Set<string>();

/** The last few, so that nothing large is handed to the workers twice. */
let made: readonly { readonly key: string; readonly resources: Resources }[] = [];

/** What specs need of the files that were dropped. */
export function resourcesOf(specs: Specs): Needed {
  const named = namedBy(specs);
  if (named.length === 0) return NOTHING;
  const photograph = named.find((one) => one.kind === "photograph");
  const grain = photograph === undefined ? undefined : grainOf(photograph, specs.pearl);
  if (photograph !== undefined && grain === undefined) return { waits: true, failed: "" };
  if (typeof grain === "string") return { waits: false, failed: grain };
  const place = grain === undefined ? [] : placesOf(specs);
  const keys = named.map((one) => `${one.serial} ${one.name}`);
  const key = [...keys, grain && grainKey(photograph, specs.pearl), place].join("\n");
  const found = made.find((one) => one.key === key);
  if (found !== undefined) return { ...NOTHING, resources: found.resources };
  const resources: Resources = {
    spectra: Object.fromEntries(
      named.flatMap((one) => (one.kind === "light" ? [[one.name, one.values]] : [])),
    ),
    panoramas: named.flatMap((one) => (one.kind === "panorama" ? [one.panorama] : [])),
    grains: grain === undefined ? [] : place.map((pearl) => ({ pearl, ...grain })),
  };
  made = [{ key, resources }, ...made.slice(0, 3)];
  return { ...NOTHING, resources };
}

function grainKeys({ texture }: Pearl): GrainKeys {
  const { side_px, mm_per_pixel, low_per_mm, high_per_mm } = texture;
  return { side_px, mm_per_pixel, low_per_mm, high_per_mm };
}

function grainKey(photograph: Dropped | undefined, pearl: Pearl): string {
  return `${photograph?.serial} ${JSON.stringify(grainKeys(pearl))}`;
}

/** A photograph's grain as this pearl measures it; asked for once, and undefined until it is there. */
function grainOf(photograph: Dropped, pearl: Pearl): Grain | string | undefined {
  if (photograph.kind !== "photograph") return undefined;
  const key = grainKey(photograph, pearl);
  const found = grains.value.get(key);
  if (found !== undefined || asked.has(key)) return found;
  asked.add(key);
  const keep = (one: Grain | string) => (grains.value = new Map([...grains.value, [key, one]]));
  ask("grain", { bytes: photograph.bytes, how: grainKeys(pearl) }).then(keep, (error: unknown) => {
    const text = (error as Error).message;
    // The room speaks of the key itself; a decoder, of the file.
    keep(text.startsWith("texture:") ? text : `${label(photograph.name)}: ${text}`);
  });
  return undefined;
}

/** The numbers of the recipe's pearls whose grain is the photograph's. */
function placesOf(specs: Specs): readonly number[] {
  const { pearls } = JSON.parse(recipeJson(specs, 1, 1)) as {
    readonly pearls: readonly { readonly texture: { readonly source: string } }[];
  };
  return pearls.flatMap((one, i) => (one.texture.source === specs.pearl.texture.source ? [i] : []));
}
