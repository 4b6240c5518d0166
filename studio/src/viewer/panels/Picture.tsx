/** A picture: the first one at once, the whole one when the hand rests. */

import { useLayoutEffect, useRef } from "preact/hooks";
import type { Pool } from "../light/pool";
import type { Resources } from "nacreous-wasm";
import { FirstSize } from "../light/first";
import { put } from "../light/screen";
import { type Specs, recipeJson } from "../specs/spec";
import { faultsIn } from "../state/faults";
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

/** How long a hand rests before the picture is refined: longer than a first picture takes, and than between events of a mouse.
 * The workers wait for it, for the page would be busy drawing what it says of itself when the first picture comes. Once they
 * refine they look up every 50 ms and sooner. */
const REST_MS = 50;

interface Given {
  readonly specs: Specs;
  /** Whether a hand is on a knob, which may go on. */
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
    failed: "",
    resources: undefined as Resources | undefined,
  });
  const { resources, waits, failed } = resourcesOf(specs);
  // Not an effect that waits for a frame: the hand would feel it.
  useLayoutEffect(() => {
    show();

    function show(): void {
      const seen = shown.current;
      // What was asked for before may still come, and must not take away what is wrong now.
      const say = (share: number) => tell({ stage: seen.stage, share, failed: seen.failed });
      const wrong = whyNot(specs) || failed;
      seen.failed = wrong;
      if (wrong !== "") return say(1);
      if (waits) return say(0);
      const recipe = recipeJson(specs, size, SAMPLES);
      if (seen.resources !== resources) seen.whole = seen.first = "";
      seen.resources = resources;
      if (seen.whole === recipe && seen.asked === recipe) return say(1); // it is there, and nothing else comes
      seen.asked = recipe;
      if (seen.stage === "refined") seen.stage = "first"; // what is seen is of before
      say(0);
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
        restMs: moving ? REST_MS : 0,
        first(made, isCurrent) {
          draw(made.codes, made.widthPx);
          seen.sizes.learn(made);
          if (isCurrent) seen.first = recipe;
          seen.whole = "";
          seen.stage = "first";
          finish(null);
          say(0);
        },
        progress: say,
        refined(whole) {
          draw(whole.codes, whole.size);
          finish({ recipe, ...whole });
          seen.first = seen.whole = recipe;
          seen.stage = "refined";
          say(1);
        },
        failed(text) {
          if (seen.failed === "") seen.failed = text;
          say(1);
        },
      });
    }
  }, [specs, size, resources, waits, failed]);
}

/** Why no picture can be made of these specs; "" where one can. */
function whyNot(specs: Specs): string {
  const [wrong] = faultsIn(specs);
  if (wrong !== undefined) return wrong.text;
  try {
    recipeJson(specs, 1, SAMPLES);
    return "";
  } catch (error) {
    return (error as Error).message;
  }
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
