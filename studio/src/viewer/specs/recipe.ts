/** Everything that makes a picture, for the renderer: `nacreous/recipe.py`, `nacreous/rows.py`. */

import { PEARLS } from "./presets";
import { type Pearl, Refusal, type Scene, type Specs } from "./types";
import { specJson, toToml } from "./write";

/** The recipe of a picture; throws a Refusal where the scene's rows ask for more than one pearl. */
export function recipeJson({ pearl, scene }: Specs, size: number, samples: number): string {
  const filled = fill(pearl, scene);
  const sceneJson = specJson("scene", filled.scene);
  const pearls = filled.pearls.map((one) => specJson("pearl", one)).join(", ");
  return `{"pearls": [${pearls}], "scene": ${sceneJson}, "size": ${size}, "samples": ${samples}}`;
}

/** What a picture's file keeps of its recipe, and the pearls of it in JSON: `recipe.py` `texts`. */
export interface RecipeTexts {
  readonly pearls: readonly { readonly json: string; readonly seed: string }[];
  readonly texts: readonly (readonly [keyword: string, text: string])[];
}

/** files: what each dropped file that is named held, as its SHA-256. */
export function recipeTexts(specs: Specs, files: ReadonlyMap<string, string>): RecipeTexts {
  const { pearls, scene } = fill(specs.pearl, specs.scene);
  const keyword = (i: number) => (pearls.length === 1 ? "pearl" : `pearl.${i}`);
  const held = [...files].map(([name, sha]) => `${JSON.stringify(name)}: ${JSON.stringify(sha)}`);
  return {
    pearls: pearls.map((one) => ({
      json: specJson("pearl", one),
      seed: "seed" in one.nacre ? String(one.nacre.seed) : "null",
    })),
    texts: [
      ...pearls.map((one, i) => [keyword(i), toToml("pearl", one)] as const),
      ["scene", toToml("scene", scene)],
      ...(held.length > 0 ? [["files", `{${held.join(", ")}}`] as const] : []),
    ],
  };
}

/** rows.py `fill`: each different pearl once, and the scene that names them by number. */
function fill(given: Pearl, scene: Scene): { pearls: readonly Pearl[]; scene: Scene } {
  if (scene.rows.length === 0) return { pearls: [given], scene };
  const numbers = new Map<string, number>();
  const pearls: Pearl[] = [];
  const rows = scene.rows.map((row) => ({
    ...row,
    pearls: row.pearls.map((name) => {
      const pearl = named(name, given, scene);
      const text = specJson("pearl", pearl);
      const number = numbers.get(text) ?? numbers.size;
      if (number === pearls.length) pearls.push(pearl);
      numbers.set(text, number);
      return `*${number}`;
    }),
  }));
  return { pearls, scene: { ...scene, rows } };
}

function named(name: string, given: Pearl, scene: Scene): Pearl {
  if (name === "*" || /^\*0+$/.test(name)) return given;
  const pearl = PEARLS.get(name);
  if (pearl) return pearl;
  throw new Refusal(`scene ${scene.name}: a row has "${name}"; allowed: "*0" to "*0", for 1 given`);
}
