/**
 * What may be wrong between keys that are each right: each function has beside it the method in
 * `nacreous/spec/` that says the same. `tests/viewer/test_specs.py` compares the two.
 */

import { dateOf, yearOf } from "./checks";
import { type Given, strangers } from "./model";
import { general } from "./number";
import { thinLayers, thinProtein } from "./thinness";
import type { Nacre, Pearl, Scene } from "./types";
import type { Value } from "./value";
import { shown } from "./words";

/** `{other}` in the verdict stands for the other key's full path. */
export interface Contradiction {
  readonly key: string;
  readonly verdict: string;
  readonly other?: string;
}

type Found = Generator<Contradiction>;
type Grown = Extract<Nacre, { preset: string }>;
type Listed = Exclude<Nacre, { preset: string }>;
type Lamp = Scene["lamps"][number];
type Window = Scene["windows"][number];

const LUMP = 5;
const NEAREST_MM = 20;
const MOST_PEARLS = 400;
const MOST_DAYS = 20 * 365 + 5;

/** What a lamp's or a window's three numbers measure together: `math.hypot`. */
function length(position: readonly number[]): number {
  return Math.hypot(...position);
}

/** A checked value as a file would have it. */
function written(value: unknown): string {
  const plain = typeof value === "object" && value !== null && !Array.isArray(value);
  return shown(plain ? new Map() : (value as Value));
}

/** pearl.py `Pearl.contradictions` */
function* ofPearl(pearl: Pearl, given: Given): Found {
  for (const { key, model } of strangers(pearl, "Pearl", pearl.model, given)) {
    const verdict = `is given while {other} is "${pearl.model}"; allowed: only with {other} = "${model}"`;
    yield { key, verdict, other: "model" };
  }
  yield* unfitMedia(pearl);
  const radius = 0.5 * pearl.diameter_mm;
  const { body, shape } = pearl;
  const within = [
    ["body.nacre_mm", body?.nacre_mm],
    ["shape.drill_mm", shape?.drill_mm],
  ] as const;
  for (const [key, size] of within) {
    if (size === undefined || size === null || size <= radius) continue;
    const half = `up to half of {other}, which is ${general(radius)} mm`;
    yield { key, verdict: `is ${general(size)}; allowed: ${half}`, other: "diameter_mm" };
  }
  const least = LUMP * (shape?.lumps ?? 0) * radius;
  const lump = shape?.lump_mm ?? null;
  if (lump !== null && lump < least) {
    const allowed = `at least ${LUMP} x {other} x half of diameter_mm, ${general(least)} mm`;
    const verdict = `is ${general(lump)}; allowed: ${allowed}`;
    yield { key: "shape.lump_mm", verdict, other: "shape.lumps" };
  }
}

/** pearl.py `Pearl._unfit_media`, with medium.py `loss` and `is_isotropic` */
function* unfitMedia({ nacre, model }: Pearl): Found {
  for (const name of ["aragonite", "protein"] as const) {
    const medium = nacre[name];
    const isPair = typeof medium === "object" && "length" in medium;
    const isTable = typeof medium === "object" && !isPair;
    let allowed = "";
    if (isPair && medium[1] > 0) {
      allowed = "k = 0; what absorbs is body.pigment";
    } else if (model === "illuminant" && (isTable || medium === "aragonite")) {
      allowed = "an index that is the same in all directions, such as 1.53";
    } else {
      continue;
    }
    const verdict = `is ${written(medium)} while {other} is "${model}"; allowed: ${allowed}`;
    yield { key: `nacre.${name}`, verdict, other: "model" };
  }
}

/** nacre.py `Nacre.contradictions` */
function* ofNacre(nacre: Nacre): Found {
  const verdict = thinProtein(nacre.protein_nm);
  if (verdict !== undefined) yield { key: "protein_nm", verdict };
}

/** nacre.py `Layers.contradictions` */
function* ofLayers(layers: Listed): Found {
  yield* ofNacre(layers);
  const verdict = thinLayers(layers.thickness_nm);
  if (verdict !== undefined) yield { key: "thickness_nm", verdict };
}

/** growth.py `Growth.contradictions` */
function* ofGrowth(growth: Grown): Found {
  yield* ofNacre(growth);
  yield* wrongDates(growth);
  const { thickness_winter_nm: winter, thickness_summer_nm: summer } = growth;
  const other = winter < summer ? "thickness_winter_nm" : "thickness_summer_nm";
  const thinnest = growth[other];
  if (growth.thickness_noise_nm >= thinnest) {
    const allowed = `less than {other}, which is ${general(thinnest)} nm`;
    const verdict = `is ${general(growth.thickness_noise_nm)}; allowed: ${allowed}`;
    yield { key: "thickness_noise_nm", verdict, other };
  }
  if (growth.layers_winter === 0 && growth.layers_summer === 0 && growth.layers_noise === 0) {
    yield {
      key: "layers_summer",
      verdict:
        "is 0, and so are layers_winter and layers_noise: no layer would grow; " +
        "allowed: at least one of the three above 0",
    };
  }
}

/** growth.py `Growth._wrong_dates`, with `Growth.days` */
function* wrongDates({ seeding, harvest }: Grown): Found {
  if (seeding.length !== harvest.length) {
    const verdict = `is "${harvest}" and {other} is "${seeding}"; allowed: both with a year or both without`;
    yield { key: "harvest", verdict, other: "seeding" };
    return;
  }
  const start = dateOf(seeding) ?? 0;
  let end = dateOf(harvest) ?? 0;
  if (harvest.length === 5 && end <= start) end = dateOf(harvest, yearOf(harvest) + 1) ?? 0;
  const days = end - start;
  if (days < 1 || days > MOST_DAYS) {
    const allowed = `1 day to 20 years after {other}, which is "${seeding}"`;
    yield { key: "harvest", verdict: `is "${harvest}"; allowed: ${allowed}`, other: "seeding" };
  }
}

/** texture.py `Texture.contradictions` */
function* ofTexture({ low_per_mm: low, high_per_mm: high }: Pearl["texture"]): Found {
  if (low === null || high === null || low < high) return;
  const allowed = `less than {other}, which is ${general(high)} cycles per mm`;
  const verdict = `is ${general(low)}; allowed: ${allowed}`;
  yield { key: "low_per_mm", verdict, other: "high_per_mm" };
}

/** lamp.py `Lamp.contradictions` */
function* ofLamp(lamp: Lamp): Found {
  const angles = ["azimuth_deg", "elevation_deg"] as const;
  const given = angles.filter((name) => lamp[name] !== null);
  const position = lamp.position_mm;
  if (position === null) {
    if (given.length === 2) return;
    const missing = given[0] === "azimuth_deg" ? "elevation_deg" : "azimuth_deg";
    const other = missing === "azimuth_deg" ? "elevation_deg" : "azimuth_deg";
    const verdict = "is missing: give it together with {other}, or give position_mm";
    yield { key: missing, verdict, other };
    return;
  }
  for (const key of given) {
    const verdict = "cannot stand beside {other}: a lamp has one place";
    yield { key, verdict, other: "position_mm" };
  }
  if (length(position) <= NEAREST_MM) {
    yield { key: "position_mm", verdict: tooNear(position, "more than") };
  }
}

function tooNear(position: readonly number[], allowed: string): string {
  const distance = `${general(length(position), 3)} mm from the centre`;
  return `is ${written(position)}, ${distance}; allowed: ${allowed} ${NEAREST_MM} mm, clear of any pearl`;
}

/** window.py `Window.contradictions` */
function* ofWindow(window: Window): Found {
  const ways = [["azimuth_deg", "elevation_deg", "distance_mm"], ["position_mm"], ["below_mm"]];
  const used = ways
    .map((way) => way.filter((name) => window[name as keyof Window] !== null))
    .filter((way) => way.length > 0);
  const [first, ...others] = used;
  if (!first) {
    const verdict = "is missing: give it, or give position_mm or below_mm";
    yield { key: "azimuth_deg", verdict };
  }
  for (const way of others) {
    const verdict = "cannot stand beside {other}: a window has one place";
    yield { key: way[0] ?? "", verdict, other: first?.[0] ?? "" };
  }
  const isByAngle = first?.some((name) => ways[0]?.includes(name));
  if (isByAngle && others.length === 0) {
    for (const key of ["azimuth_deg", "elevation_deg"]) {
      if (first?.includes(key)) continue;
      const verdict = "is missing: give it together with {other}";
      yield { key, verdict, other: first?.[0] ?? "" };
    }
  }
  yield* direction(window);
}

/** window.py `Window._direction` */
function* direction({ facing, position_mm: position }: Window): Found {
  if (facing !== null && position === null) {
    yield { key: "facing", verdict: "is of use only with position_mm, which is missing" };
  }
  if (facing !== null && length(facing) < 1e-9) {
    yield { key: "facing", verdict: `is ${written(facing)}; allowed: three numbers, not all 0` };
  }
  if (position !== null && length(position) < NEAREST_MM) {
    yield { key: "position_mm", verdict: tooNear(position, "at least") };
  }
}

/** scene.py `Sky.contradictions` */
function* ofSky({ kind, path }: Scene["sky"]): Found {
  if ((kind === "panorama") === (path !== null)) return;
  const is = path === null ? "missing" : shown(path);
  const verdict = `is ${is} while {other} is "${kind}"; allowed: a path with "panorama", and only with it`;
  yield { key: "path", verdict, other: "kind" };
}

/** scene.py `Scene.contradictions` */
function* ofScene({ windows, rows, table }: Scene): Found {
  for (const [number, { below_mm: below }] of windows.entries()) {
    if (below === null || table.kind === "none") continue;
    const verdict = `is ${shown(below)} while {other} is ${shown(table.kind)}, which hides it; allowed: only with "none"`;
    yield { key: `windows.${number}.below_mm`, verdict, other: "table.kind" };
  }
  const names = rows.flatMap((row) => row.pearls);
  if (names.length > MOST_PEARLS) {
    const verdict = `hold ${names.length} pearls together; allowed: at most ${MOST_PEARLS}`;
    yield { key: "rows", verdict };
  }
  if (names.length > 0 && !names.some((name) => name.startsWith("*"))) {
    yield { key: "rows", verdict: 'have no "*"; wanted: a place for the pearl given' };
  }
}

/** By the class in Python. */
export const RULES: Readonly<
  Record<string, (table: never, given: Given) => Iterable<Contradiction>>
> = {
  Growth: ofGrowth,
  Lamp: ofLamp,
  Layers: ofLayers,
  Pearl: ofPearl,
  Scene: ofScene,
  Sky: ofSky,
  Texture: ofTexture,
  Window: ofWindow,
};
