/** How a hand turns the camera and moves a light. */

import type { Scene, Specs } from "../specs/spec";

/** Degrees a pixel of dragging. */
const TURN = 0.35;

const clamp = (value: number, least: number, most: number) =>
  Math.min(most, Math.max(least, value));
const tenth = (value: number) => Math.round(value * 10) / 10;

/** An angle from -180 to 180 degrees. */
export function around(degrees: number): number {
  return tenth(((((degrees + 180) % 360) + 360) % 360) - 180);
}

export type Values = Readonly<Record<string, number>>;

/** The camera after dragging by so many pixels: what is seen goes along with the hand. */
export function turned({ camera, table }: Scene, right: number, down: number): Values {
  const least = table.kind === "none" ? -80 : 0; // below a table there is nothing to see
  const elevation = camera.elevation_deg + down * TURN;
  return {
    "camera.azimuth_deg": around(camera.azimuth_deg - right * TURN),
    "camera.elevation_deg": tenth(clamp(elevation, Math.min(least, camera.elevation_deg), 89)),
  };
}

/** The camera with its view wider by a factor. */
export function zoomed({ pearl, scene }: Specs, factor: number): Values {
  const rows = Math.max(1, ...scene.rows.map((row) => row.pearls.length));
  const usual = 1.5 * pearl.diameter_mm * rows; // where the width is left open
  const field = (scene.camera.field_mm ?? usual) * factor;
  return { "camera.field_mm": Number(clamp(field, 0.5, 1000).toPrecision(4)) };
}

/** A light that can be moved: where it stands in the scene, and how it is called. */
export interface Light {
  readonly path: string;
  readonly kind: "lamp" | "window";
  readonly number: number;
  readonly azimuth: number;
  readonly elevation: number;
  /** Distance where the light stands at a position, in mm. */
  readonly distanceMm: number | null;
}

type Placed = Scene["lamps"][number] | Scene["windows"][number];

/** The scene's lights that have a direction. */
export function lights(scene: Scene): Light[] {
  const placed = (kind: Light["kind"], list: readonly Placed[]) =>
    list.flatMap((one, i) => {
      const direction = directionOf(one);
      return direction === null
        ? []
        : [{ path: `${kind}s.${i}`, kind, number: i + 1, ...direction }];
    });
  return [...placed("lamp", scene.lamps), ...placed("window", scene.windows)];
}

function directionOf(one: Placed): Pick<Light, "azimuth" | "elevation" | "distanceMm"> | null {
  if (one.azimuth_deg !== null && one.elevation_deg !== null) {
    return { azimuth: one.azimuth_deg, elevation: one.elevation_deg, distanceMm: null };
  }
  if (one.position_mm === null) return null;
  const [x, y, z] = one.position_mm;
  const distanceMm = Math.hypot(x, y, z);
  if (distanceMm === 0) return null;
  const degrees = 180 / Math.PI;
  return {
    azimuth: tenth(Math.atan2(x, z) * degrees),
    elevation: tenth(Math.asin(y / distanceMm) * degrees),
    distanceMm,
  };
}

/** The keys of a light that is moved to another direction. */
export function moved(light: Light, azimuth: number, elevation: number): Record<string, unknown> {
  const [side, height] = [around(azimuth), tenth(clamp(elevation, 0, 90))];
  if (light.distanceMm === null) {
    return { [`${light.path}.azimuth_deg`]: side, [`${light.path}.elevation_deg`]: height };
  }
  const [a, e] = [(side * Math.PI) / 180, (height * Math.PI) / 180];
  const level = Math.cos(e) * light.distanceMm;
  const position = [Math.sin(a) * level, Math.sin(e) * light.distanceMm, Math.cos(a) * level];
  const facing = light.kind === "window" ? { [`${light.path}.facing`]: null } : {};
  return { [`${light.path}.position_mm`]: position.map(tenth), ...facing };
}
