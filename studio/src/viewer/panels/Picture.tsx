/** A picture: the first one at once, the whole one when the hand rests. */

import { useLayoutEffect, useRef } from "preact/hooks";
import type { Pool } from "../light/pool";
import { nextPx } from "../light/first";
import { put } from "../light/screen";
import { type Specs, recipeJson } from "../specs/spec";
import { faultsOf } from "../state/faults";
import { SAMPLES, SPACE } from "../state/engines";
import type { Finished } from "../state/instruments";

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
  /** Takes the picture at rest, for the instruments. */
  readonly keep: (made: Finished) => void;
}

/** Keeps a canvas showing these specs. */
export function usePicture({ specs, moving, size, pool, canvas, tell, keep }: Given): void {
  const shown = useRef({
    asked: "",
    first: "",
    firstPx: 256,
    whole: "",
    stage: null as Making["stage"],
  });
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
      if (seen.whole === recipe && seen.asked === recipe) return; // it is there, and nothing else comes
      seen.asked = recipe;
      const draw = (codes: Uint8ClampedArray<ArrayBuffer>, widthPx: number) => {
        if (canvas.current !== null) put(canvas.current, codes, widthPx, SPACE);
      };
      pool().show({
        recipe,
        size,
        space: SPACE,
        firstPx: seen.first === recipe ? 0 : Math.min(size, seen.firstPx),
        refine: !moving,
        first(made, isCurrent) {
          draw(made.codes, made.widthPx);
          seen.firstPx = nextPx(made);
          if (isCurrent) seen.first = recipe;
          seen.whole = "";
          seen.stage = "first";
          tell({ stage: "first", share: 0, failed: "" });
        },
        progress: (share) => tell({ stage: seen.stage, share, failed: "" }),
        refined(codes, widthPx, light) {
          draw(codes, widthPx);
          keep({ recipe, size: widthPx, light });
          seen.first = seen.whole = recipe;
          seen.stage = "refined";
          tell({ stage: "refined", share: 1, failed: "" });
        },
        failed: (text) => tell({ stage: seen.stage, share: 1, failed: text }),
      });
    }
  }, [specs, moving, size]);
}
