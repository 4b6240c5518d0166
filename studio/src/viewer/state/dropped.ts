/**
 * The files that were dropped onto the page and that a pearl or a scene may name: panoramas,
 * measured lights, photographs of grain. They stay in the page: in no link, and sent to nobody.
 */

import { computed, signal } from "@preact/signals";
import type { Panorama } from "nacreous-wasm";
import type { Specs } from "../specs/spec";

type Bytes = Uint8Array<ArrayBuffer>;

export type Dropped = {
  readonly name: string;
  /** Another number for each file that was dropped, also of the same name. */
  readonly serial: number;
  /** null where the browser makes none: on pages from other machines without https. */
  readonly sha256: string | null;
} & (
  | { readonly kind: "panorama"; readonly panorama: Panorama }
  | { readonly kind: "light"; readonly values: Float64Array }
  | { readonly kind: "photograph"; readonly bytes: Bytes }
);

export const dropped = signal<ReadonlyMap<string, Dropped>>(new Map());

export const droppedNames = computed<ReadonlySet<string>>(() => new Set(dropped.value.keys()));

export function keepDropped(one: Dropped): void {
  dropped.value = new Map([...dropped.value, [one.name, one]]);
}

/** The dropped files that these specs name. */
export function namedBy({ pearl, scene }: Specs): readonly Dropped[] {
  const lights = [...scene.lamps, ...scene.windows].map((one) => one.spectrum);
  const names = [scene.sky.path ?? "", pearl.texture.source, ...lights];
  return [...new Set(names)].flatMap((name) => dropped.value.get(name) ?? []);
}
