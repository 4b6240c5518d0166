/** The pearls and scenes that come with Nacreous. */

import complete from "../../../../nacreous/presets/complete.json";
import type { Pearl, Scene } from "../standin/spec";

interface Preset<T> {
  readonly name: string;
  readonly values: T;
}

function listed<T>(kind: Record<string, { values: unknown }>): readonly Preset<T>[] {
  return Object.entries(kind).map(([name, one]) => ({ name, values: one.values as T }));
}

export const PEARLS = listed<Pearl>(complete.pearl);
export const SCENES = listed<Scene>(complete.scene);

/** Those that are shown first; families and masters are one click below. */
export const FEATURED = [
  "akoya-rg",
  "akoya-r",
  "akoya-g",
  "akoya-pink",
  "akoya-cream",
  "akoya-dyed-blue",
  "south-sea-white",
  "south-sea-gold",
  "tahitian",
];

export const SCENE_ORDER = [
  "north-window-black",
  "north-window-white",
  "aurora",
  "booth",
  "paper",
  "two-tier",
];

export function pearlPreset(name: string): Pearl | undefined {
  return PEARLS.find((one) => one.name === name)?.values;
}

export function scenePreset(name: string): Scene | undefined {
  return SCENES.find((one) => one.name === name)?.values;
}
