/** The instruments' worker: spectra at a point, layers, and what is measured in a picture. */

import {
  Job,
  type Measures,
  type RecipeJson,
  chromaticities,
  codesOfLab,
  initSync,
  measure,
  primariesOf,
  resolvedKeys,
  spectralLocus,
  tell_panics,
} from "nacreous-wasm";
import {
  type Answered,
  type Asked,
  type Chart,
  type Found,
  type Layers,
  type Reading,
  WAVELENGTH_NM,
} from "./instruments";

const page = self as unknown as {
  onmessage: ((event: MessageEvent<WebAssembly.Module | Asked>) => void) | null;
  postMessage(message: Answered): void;
};

let job: Job | null = null;
let asking = "";

page.onmessage = ({ data }) => {
  if (data instanceof WebAssembly.Module) {
    initSync({ module: data });
    tell_panics();
    return;
  }
  const { question } = data;
  try {
    page.postMessage({ question, answer: answerTo(data) });
  } catch (error) {
    const refused = (error as Error).message;
    if (refused.includes("broken off")) job = null;
    page.postMessage({ question, refused });
  }
};

function answerTo(asked: Asked): Reading | Layers | Found | Chart | null {
  if (asked.kind === "point") return reading(jobOf(asked.recipe), asked.row, asked.column);
  if (asked.kind === "layers") {
    return layersOf(jobOf(asked.recipe), asked.recipe, asked.pearl);
  }
  if (asked.kind === "found") return found(jobOf(asked.recipe).mmPerPixel, asked);
  return { locus: spectralLocus(), srgb: primariesOf("srgb"), p3: primariesOf("display-p3") };
}

function jobOf(recipe: RecipeJson): Job {
  if (job === null) job = new Job(recipe);
  else if (asking !== recipe) job.change(recipe);
  asking = recipe;
  return job;
}

function reading(job: Job, row: number, column: number): Reading | null {
  const sight = job.sight(row, column);
  if (sight === undefined) return null;
  const { pearl, viewRad } = sight;
  const here = { row, column, pearl, angleRad: viewRad };
  try {
    const [R, T] = job.filmSpectra(pearl, Float64Array.of(viewRad), WAVELENGTH_NM);
    return { ...here, film: { R, T }, why: "" };
  } catch (error) {
    return { ...here, film: null, why: (error as Error).message };
  }
}

/** As much of a recipe as is looked at here. */
interface Recipe {
  readonly pearls: readonly {
    readonly nacre: { readonly protein_nm: number; readonly seeding?: string };
    readonly film?: { readonly outer_um: number | null };
  }[];
}

function layersOf(job: Job, recipe: RecipeJson, number: number): Layers {
  const pearl = (JSON.parse(recipe) as Recipe).pearls[number];
  if (pearl === undefined) throw new Error(`there is no pearl ${number}`);
  const { protein_nm: proteinNm, seeding } = pearl.nacre;
  const depth = () => resolvedKeys(JSON.stringify(pearl))["film.outer_um"] ?? null;
  const filmUm = pearl.film === undefined ? null : (pearl.film.outer_um ?? depth());
  const known = { thicknessNm: job.thicknessNm(number), proteinNm, filmUm };
  if (seeding === undefined) return { ...known, seeding: "", grown: null };
  const { day, warmth } = job.grow(number);
  return { ...known, seeding, grown: { day: day.reverse(), warmth: warmth.reverse() } };
}

function found(mmPerPixel: number, asked: Extract<Asked, { kind: "found" }>): Found {
  const { light, size } = asked;
  let measures: Measures;
  try {
    measures = measure(light, size, size, mmPerPixel);
  } catch (error) {
    const why = (error as Error).message;
    return { measures: null, why, xy: new Float32Array(), ringCodes: new Uint8ClampedArray() };
  }
  const xy = chromaticities(lightWithin(light, size, measures));
  const lab = (measures.rings?.rings ?? []).flatMap(({ colour }) => {
    if (colour === null) return [0, 0, 0, 0, 0, 0];
    const turn = ((colour.hue_deg?.value ?? 0) * Math.PI) / 180;
    const [L, C] = [colour.lightness.value, colour.chroma.value];
    return [C, STRONGER * C].flatMap((c) => [L, c * Math.cos(turn), c * Math.sin(turn)]);
  });
  return { measures, why: "", xy, ringCodes: codesOfLab(Float64Array.from(lab), "srgb", "soft") };
}

/** The second half of each ring is shown with so many times its chroma. */
const STRONGER = 3;
/** So many pixels tell where a pearl's colours lie. */
const ENOUGH = 4000;

/** The light of some pixels of the pearl, evenly from its whole disc. */
function lightWithin(light: Float32Array, size: number, { place }: Measures): Float32Array {
  const { x_px, y_px, radius_px } = place.circle;
  const step = Math.max(1, Math.round(Math.sqrt((Math.PI * radius_px ** 2) / ENOUGH)));
  const taken: number[] = [];
  for (let row = 0; row < size; row += step) {
    for (let column = 0; column < size; column += step) {
      const away = Math.hypot(column + 0.5 - x_px, row + 0.5 - y_px) / radius_px;
      const at = 3 * (row * size + column);
      if (away < 0.96) taken.push(light[at] ?? 0, light[at + 1] ?? 0, light[at + 2] ?? 0);
    }
  }
  return Float32Array.from(taken);
}
