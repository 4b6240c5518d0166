/** Which keys stand together, as the trade thinks of them. */

import { type Declaration, type Kind, declarations } from "../specs/spec";
import type { Word } from "../words/en";
import { declared, valueAt } from "./path";

export interface Group {
  readonly title: Word;
  /** The trade's word for it. */
  readonly trade?: Word;
  readonly knobs: readonly string[];
  /** One click below. */
  readonly physics: readonly string[];
}

/** What most is done with. */
export const ESSENTIALS: readonly string[] = [
  "nacre.harvest",
  "nacre.thickness_winter_nm",
  "nacre.thickness_summer_nm",
  "nacre.thickness_noise_nm",
  "depth",
  "shininess",
  "grain",
  "body.pigment",
  "body_colour",
];

export const PEARL_GROUPS: readonly Group[] = [
  {
    title: "luster",
    trade: "lusterTrade",
    knobs: ["surface.waviness_rad"],
    physics: [
      "surface.facet_spread_rad",
      "surface.facets",
      "surface.mirror_weight",
      "surface.layer_reflectance",
      "surface.falloff_mm",
    ],
  },
  {
    title: "orient",
    trade: "orientTrade",
    knobs: [
      "coat.thickness_spread",
      "coat.patch_mm",
      "coat.banding",
      "coat.liveliness",
      "interference.mixing",
    ],
    physics: [
      "film.outer_um",
      "film.columns",
      "film.column_spread_nm",
      "inside.spread",
      "nacre.protein_nm",
      "nacre.aragonite",
      "nacre.protein",
      "interference.coherence_nm",
      "interference.threshold",
      "interference.diffuse_loss",
      "coat.seed",
    ],
  },
  {
    title: "colour",
    trade: "colourTrade",
    knobs: ["body.pigment_strength"],
    physics: [
      "body.scattering_per_mm",
      "body.nucleus",
      "body.nucleus_bands",
      "body.nucleus_band_mm",
    ],
  },
  {
    title: "surface",
    trade: "surfaceTrade",
    knobs: [
      "blemishes.pits",
      "blemishes.bumps",
      "blemishes.scratches",
      "blemishes.wrinkles",
      "blemishes.chalky_spots",
      "coat.hammering_rad",
      "coat.terrace_um",
    ],
    physics: [
      "blemishes.size_mm",
      "blemishes.depth_um",
      "blemishes.area",
      "blemishes.seed",
      "coat.dent_mm",
      "coat.grain_relief_rad",
      "coat.terrace_step_nm",
      "texture.hue_weight",
      "texture.chroma_weight",
      "texture.value_weight",
      "texture.low_per_mm",
      "texture.high_per_mm",
      "texture.seed",
      "texture.source",
      "texture.mm_per_pixel",
      "texture.side_px",
    ],
  },
  {
    title: "shape",
    trade: "shapeTrade",
    knobs: [
      "shape.length",
      "shape.taper",
      "shape.flattening",
      "shape.out_of_round",
      "shape.lumps",
      "shape.circles",
      "pose.turn_deg",
      "pose.tilt_deg",
      "pose.spin_deg",
    ],
    physics: [
      "shape.lump_mm",
      "shape.circle_depth",
      "shape.drill_mm",
      "shape.drill_wear_mm",
      "shape.seed",
    ],
  },
  { title: "size", trade: "sizeTrade", knobs: ["diameter_mm"], physics: [] },
  {
    title: "nacre",
    trade: "nacreTrade",
    knobs: ["body.nacre_mm", "nacre.seeding", "nacre.peak", "nacre.season_days"],
    physics: [
      "nacre.layers_winter",
      "nacre.layers_summer",
      "nacre.layers_noise",
      "nacre.seed",
      "nacre.preset",
      "nacre.thickness_nm",
    ],
  },
  { title: "other", knobs: ["name", "model"], physics: [] },
];

const all = (kind: Kind, head: string) =>
  declarations(kind)
    .map((one) => declared(one.path))
    .filter((path) => path.startsWith(head));

export const LAMP_KEYS = all("scene", "lamps.");
export const WINDOW_KEYS = all("scene", "windows.");
export const ROW_KEYS = all("scene", "rows.");

export const SCENE_GROUPS: readonly Group[] = [
  {
    title: "camera",
    knobs: ["camera.exposure", "camera.elevation_deg", "camera.azimuth_deg", "camera.field_mm"],
    physics: [
      "camera.projection",
      "camera.distance_mm",
      "camera.white",
      "camera.glare",
      "camera.glare_deg",
      "observer",
    ],
  },
  {
    title: "around",
    knobs: ["sky.intensity", "sky.kind", "sky.horizon", "sky.zenith"],
    physics: ["sky.path", "sky.rotation_deg"],
  },
  {
    title: "table",
    knobs: ["table.kind", "table.colour", "table.second_colour"],
    physics: [
      "table.check_mm",
      "table.weave_mm",
      "walls.half_width_mm",
      "walls.height_mm",
      "walls.colour",
    ],
  },
  { title: "other", knobs: ["name"], physics: ["pitch_mm", "row_gap_mm"] },
];

const byPath = {
  pearl: new Map(declarations("pearl").map((one) => [declared(one.path), one])),
  scene: new Map(declarations("scene").map((one) => [declared(one.path), one])),
};

/** How a key is declared, wherever in a list it stands. */
export function declaration(kind: Kind, path: string): Declaration | undefined {
  return byPath[kind].get(declared(path));
}

const grouped = (groups: readonly Group[]) =>
  groups.flatMap((group) => [...group.knobs, ...group.physics]);
const LISTED = [...LAMP_KEYS, ...WINDOW_KEYS, ...ROW_KEYS];
const KNOBS = {
  pearl: new Set([...ESSENTIALS, ...grouped(PEARL_GROUPS)]),
  scene: new Set([...grouped(SCENE_GROUPS), ...LISTED]),
};

/** Whether the page has a knob for just this key; of what stands in the place of another it has none. */
export function hasKnob(kind: Kind, spec: unknown, path: string): boolean {
  const value = valueAt(spec, path);
  const key = declared(path);
  const isThere = value !== undefined && !(value === null && LISTED.includes(key));
  return isThere && KNOBS[kind].has(key) && !/\.\d+$/.test(path);
}
