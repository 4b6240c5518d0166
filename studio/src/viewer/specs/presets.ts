/** The presets that come along, complete: what `nacreous presets --json` prints. */

import complete from "../../../../nacreous/presets/complete.json";
import type { Nacre, Pearl, Scene } from "./types";

interface Ready<T> {
  readonly summary: string;
  readonly values: T;
}

interface ReadyScene extends Ready<Scene> {
  /** The pearls that its rows name by number; null for the pearl that is shown. */
  readonly pearls: readonly (Pearl | null)[];
}

const ALL = complete as unknown as {
  readonly pearl: Readonly<Record<string, Ready<Pearl>>>;
  readonly scene: Readonly<Record<string, ReadyScene>>;
  readonly nacre: Readonly<Record<string, Ready<Nacre>>>;
};

export const PEARLS: ReadonlyMap<string, Pearl> = values(ALL.pearl);
export const NACRES: ReadonlyMap<string, Nacre> = values(ALL.nacre);
export const SCENES: ReadonlyMap<string, Scene> = new Map(
  Object.entries(ALL.scene).map(([name, { values: scene, pearls }]) => [
    name,
    named(scene, pearls),
  ]),
);

/** What a preset is, in one line. */
export function summary(kind: "pearl" | "scene", name: string): string {
  return ALL[kind][name]?.summary ?? "";
}

function values<T>(ready: Readonly<Record<string, Ready<T>>>): ReadonlyMap<string, T> {
  return new Map(Object.entries(ready).map(([name, one]) => [name, one.values]));
}

/** A scene whose rows name pearls by their presets again, as its file does. */
function named(scene: Scene, pearls: readonly (Pearl | null)[]): Scene {
  if (scene.rows.length === 0) return scene;
  const names = pearls.map((pearl) => (pearl ? presetOf(pearl) : "*"));
  const rows = scene.rows.map((row) => ({
    ...row,
    pearls: row.pearls.map((number) => names[Number(number.slice(1))] ?? "*"),
  }));
  return { ...scene, rows };
}

function presetOf(pearl: Pearl): string {
  const text = JSON.stringify(pearl);
  for (const [name, { values: preset }] of Object.entries(ALL.pearl)) {
    if (JSON.stringify(preset) === text) return name;
  }
  throw new Error(`no preset is the pearl ${pearl.name} of a scene's rows`);
}
