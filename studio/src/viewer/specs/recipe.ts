/** Everything that makes a picture, for the renderer: `nacreous/recipe.py`, `nacreous/rows.py`. */

import { PEARLS } from "./presets";
import { type Pearl, Refusal, type Scene, type Specs } from "./types";
import { specJson } from "./write";

/** The recipe of a picture; throws a Refusal where the scene's rows ask for more than one pearl. */
export function recipeJson({ pearl, scene }: Specs, size: number, samples: number): string {
  const filled = fill(pearl, scene);
  const sceneJson = specJson("scene", filled.scene);
  const pearls = filled.pearls.join(", ");
  return `{"pearls": [${pearls}], "scene": ${sceneJson}, "size": ${size}, "samples": ${samples}}`;
}

/** rows.py `fill`: each different pearl once, as JSON, and the scene that names them by number. */
function fill(given: Pearl, scene: Scene): { pearls: readonly string[]; scene: Scene } {
  if (scene.rows.length === 0) return { pearls: [specJson("pearl", given)], scene };
  const numbers = new Map<string, number>();
  const rows = scene.rows.map((row) => ({
    ...row,
    pearls: row.pearls.map((name) => {
      const text = specJson("pearl", named(name, given, scene));
      const number = numbers.get(text) ?? numbers.size;
      numbers.set(text, number);
      return `*${number}`;
    }),
  }));
  return { pearls: [...numbers.keys()], scene: { ...scene, rows } };
}

function named(name: string, given: Pearl, scene: Scene): Pearl {
  if (name === "*" || /^\*0+$/.test(name)) return given;
  const pearl = PEARLS.get(name);
  if (pearl) return pearl;
  throw new Refusal(`scene ${scene.name}: a row has "${name}"; allowed: "*0" to "*0", for 1 given`);
}
