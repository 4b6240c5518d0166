/** Lamps and windows, added and taken away. */

import { declarations } from "../specs/spec";
import { edit, specs } from "./store";

type List = "lamps" | "windows";

/** Where a new light stands. */
const PLACE = { azimuth_deg: 45, elevation_deg: 45 };

/** A light with every key at its default. */
function usual(list: List): Record<string, unknown> {
  const head = `${list}.0.`;
  const keys = declarations("scene").filter((one) => one.path.startsWith(head));
  const defaults = keys.map((one) => [one.path.slice(head.length), one.default ?? null]);
  return { ...(Object.fromEntries(defaults) as Record<string, unknown>), ...PLACE };
}

export function addLight(list: List): void {
  edit("scene", list, [...specs.value.scene[list], usual(list)]);
}

export function removeLight(list: List, number: number): void {
  edit(
    "scene",
    list,
    specs.value.scene[list].filter((_, i) => i !== number),
  );
}
