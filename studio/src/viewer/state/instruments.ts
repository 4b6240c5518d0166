/** What the instruments read: the point, its pearl's layers, and the measures of the picture at rest. */

import { batch, computed, effect, signal } from "@preact/signals";
import {
  type Chart,
  type Found,
  InstrumentWorker,
  type Layers,
  type Reading,
} from "../light/instruments";
import { program } from "../light/program";
import { recipeJson } from "../specs/spec";
import { SAMPLES } from "./engines";
import { type Finished, finished } from "./finished";
import { type Which, active, board, faults, notice, specs } from "./store";
import { size, tab } from "./view";

/** A place in the picture: shares of its width and height. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** Where the instruments look while nothing is pointed at. */
export const fixed = signal<Place>({ x: 0.5, y: 0.5 });
/** What is pointed at. */
export const hovered = signal<Place | null>(null);
export const place = computed(() => hovered.value ?? fixed.value);

/** null beside the pearl, undefined before anything is read. */
export const reading = signal<Reading | null | undefined>(undefined);
/** Why nothing is read at the point, where something is wrong. */
export const trouble = signal("");
export const layers = signal<Layers | null>(null);
export const chart = signal<Chart | null>(null);
export const found = signal<Found | null>(null);
/** Whether what is found is of the picture that is shown. */
export const isFresh = signal(false);

/** Whether outline, lamp's image and spots are drawn over the picture. */
export const isDrawn = signal(false);

let worker: InstrumentWorker | null = null;

function instruments(): InstrumentWorker {
  worker ??= new InstrumentWorker(program());
  return worker;
}

/** What cannot be made is not asked for; the page says why. */
const isOn = computed(() => tab.value === "instruments" && faults.value.length === 0);
const shownSide = computed<Which>(() =>
  active.value === "b" && board.value.b !== null ? "b" : "a",
);
const recipe = computed(() => {
  try {
    return recipeJson(specs.value, size.value, SAMPLES);
  } catch {
    return null; // the picture says why
  }
});

/** Asks for one thing after the other; of those that wait, the last alone. */
function lastOf<T>(ask: (asked: T) => Promise<void>): (asked: T) => void {
  let waiting: { readonly asked: T } | null = null;
  let busy = false;
  return (asked) => {
    waiting = { asked };
    if (!busy) void go();
  };
  async function go(): Promise<void> {
    busy = true;
    while (waiting !== null) {
      const { asked } = waiting;
      waiting = null;
      await ask(asked);
    }
    busy = false;
  }
}

const readPoint = lastOf(async (asked: { recipe: string; row: number; column: number }) => {
  const { recipe } = asked;
  try {
    const read = await instruments().ask("point", asked);
    batch(() => {
      reading.value = read;
      trouble.value = "";
    });
    const key = `${read?.pearl} ${recipe}`;
    if (read === null || key === layersOf) return;
    layersOf = key;
    layers.value = await instruments().ask("layers", { recipe, pearl: read.pearl });
  } catch (error) {
    batch(() => {
      reading.value = undefined;
      layers.value = null;
      trouble.value = (error as Error).message;
      layersOf = "";
    });
  }
});
let layersOf = "";

const measurePicture = lastOf(async (made: Finished) => {
  found.value = await instruments().ask("found", made);
  measured = made;
  isFresh.value = finished[shownSide.peek()].peek() === made;
});
let measured: Finished | null = null;

/** Pixels of a share of the width. */
const pixelOf = (share: number, sizePx: number) =>
  Math.min(sizePx - 1, Math.max(0, Math.floor(share * sizePx)));

effect(() => {
  if (!isOn.value || recipe.value === null) return;
  const { x, y } = place.value;
  const [row, column] = [pixelOf(y, size.value), pixelOf(x, size.value)];
  readPoint({ recipe: recipe.value, row, column });
});

effect(() => {
  const made = finished[shownSide.value].value;
  isFresh.value = made !== null && made === measured && made.recipe === recipe.value;
  if (isOn.value && made !== null && made !== measured && made.recipe === recipe.value) {
    measurePicture(made);
  }
});

effect(() => {
  if (!isOn.value || chart.peek() !== null) return;
  void instruments()
    .ask("chart", {})
    .then((made) => (chart.value = made));
});

/** Copies numbers; says so, or that the browser does not let us. */
export async function copyNumbers(
  text: string,
  said: { done: string; not: string },
): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    notice.value = said.done;
  } catch {
    notice.value = said.not;
  }
}
