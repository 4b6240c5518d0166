/** A picture: the first one at once, the whole one when the hand rests. */

import { useLayoutEffect, useRef } from "preact/hooks";
import type { Pool } from "../light/pool";
import type { Resources } from "nacreous-wasm";
import { FirstSize } from "../light/first";
import { put } from "../light/screen";
import { type Specs, recipeJson } from "../specs/spec";
import { faultsOf } from "../state/faults";
import { resourcesOf } from "../state/resources";
import { SAMPLES, SPACE } from "../state/engines";
import type { Finished } from "../state/finished";

export interface Making {
  /** null before anything is seen. */
  readonly stage: "first" | "refined" | null;
  /** Share of the rows that are there. */
  readonly share: number;
  readonly failed: string;
}

interface Given {
  readonly specs: Specs;
  readonly moving: boolean;
  readonly size: number;
  readonly pool: () => Pool;
  readonly canvas: { current: HTMLCanvasElement | null };
  readonly tell: (making: Making) => void;
  /** Hears of the whole picture, and that there is none any more. */
  readonly finish: (finished: Finished | null) => void;
}

/** Keeps a canvas showing these specs. */
export function usePicture({ specs, moving, size, pool, canvas, tell, finish }: Given): void {
  const shown = useRef({
    asked: "",
    first: "",
    seen: null as Specs | null,
    sizes: new FirstSize(),
    whole: "",
    stage: null as Making["stage"],
    resources: undefined as Resources | undefined,
  });
  const { resources, waits, failed } = resourcesOf(specs);
  // Not an effect that waits for a frame: the hand would feel it.
  useLayoutEffect(() => {
    show();

    function show(): void {
      const seen = shown.current;
      const [wrong] = [...faultsOf("pearl", specs.pearl), ...faultsOf("scene", specs.scene)];
      if (wrong !== undefined) return tell({ stage: seen.stage, share: 1, failed: wrong.text });
      let recipe: string;
      try {
        recipe = recipeJson(specs, size, SAMPLES);
      } catch (error) {
        return tell({ stage: seen.stage, share: 1, failed: (error as Error).message });
      }
      if (failed !== "") return tell({ stage: seen.stage, share: 1, failed });
      if (waits) return tell({ stage: seen.stage, share: 0, failed: "" });
      if (seen.resources !== resources) seen.whole = seen.first = "";
      seen.resources = resources;
      if (seen.whole === recipe && seen.asked === recipe) return; // it is there, and nothing else comes
      seen.asked = recipe;
      if (seen.stage === "refined") seen.stage = "first"; // what is seen is of before
      tell({ stage: seen.stage, share: 0, failed: "" });
      const firstPx = Math.min(size, seen.sizes.next(changesView(seen.seen, specs)));
      seen.seen = specs;
      const draw = (codes: Uint8ClampedArray<ArrayBuffer>, widthPx: number) => {
        if (canvas.current !== null) put(canvas.current, codes, widthPx, SPACE);
      };
      pool().show({
        recipe,
        ...(resources === undefined ? {} : { resources }),
        size,
        space: SPACE,
        firstPx: seen.first === recipe ? 0 : firstPx,
        refine: !moving,
        first(made, isCurrent) {
          draw(made.codes, made.widthPx);
          seen.sizes.learn(made);
          if (isCurrent) seen.first = recipe;
          seen.whole = "";
          seen.stage = "first";
          finish(null);
          tell({ stage: "first", share: 0, failed: "" });
        },
        progress: (share) => tell({ stage: seen.stage, share, failed: "" }),
        refined(whole) {
          draw(whole.codes, whole.size);
          finish({ recipe, ...whole });
          seen.first = seen.whole = recipe;
          seen.stage = "refined";
          tell({ stage: "refined", share: 1, failed: "" });
        },
        failed: (text) => tell({ stage: seen.stage, share: 1, failed: text }),
      });
    }
  }, [specs, moving, size, resources, waits, failed]);
}

/** Whether pixels look at other places, or at other light, than before; else their colours alone may differ. */
function changesView(before: Specs | null, now: Specs): boolean {
  if (before === null) return false;
  const { camera, ...around } = now.scene;
  const { camera: cameraBefore, ...aroundBefore } = before.scene;
  const pearl = ({ diameter_mm, texture, coat, blemishes, shape, pose }: Specs["pearl"]) => [
    diameter_mm,
    texture,
    ...[coat, blemishes, shape, pose],
  ];
  const view = [{ ...camera, exposure: 0, glare: 0 }, around, pearl(now.pearl)];
  const viewBefore = [
    { ...cameraBefore, exposure: 0, glare: 0 },
    aroundBefore,
    pearl(before.pearl),
  ];
  return JSON.stringify(view) !== JSON.stringify(viewBefore);
}
