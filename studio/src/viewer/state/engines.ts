/** The workers of the page: those of the picture, one of the other side, one of small pictures. */

import { signal } from "@preact/signals";
import type { Codes } from "../light/messages";
import { Pool, workersFor } from "../light/pool";
import { program } from "../light/program";
import { screenSpace } from "../light/screen";
import { type Specs, recipeJson } from "../specs/spec";
import { resourcesOf } from "./resources";

/** Codes of this screen, fixed while the page is open. */
export const SPACE = screenSpace();

/** Samples a pixel of the picture at rest, as `nacreous render` has them. */
export const SAMPLES = 16;
const SMALL_PX = 96;

const processors = () => workersFor(navigator.hardwareConcurrency);

let main: Pool | null = null;
let other: Pool | null = null;
let small: Pool | null = null;

export function mainPool(): Pool {
  main ??= new Pool(processors(), program());
  return main;
}

export function otherPool(): Pool {
  other ??= new Pool(Math.max(1, Math.floor(processors() / 2)), program());
  return other;
}

/** Whether the large picture is finished: only then are small ones made. */
export const isIdle = signal(false);

export interface Small {
  readonly codes: Codes;
  readonly widthPx: number;
}

interface Job {
  readonly specs: Specs;
  readonly done: (made: Small | null) => void;
}

const cache = new Map<string, Promise<Small | null>>();
const queue: Job[] = [];
let busy = false;

/** A small picture, made when nothing else is; null where it cannot be made. */
export function smallPicture(specs: Specs): Promise<Small | null> {
  let key: string;
  try {
    key = recipeJson(specs, SMALL_PX, 1);
  } catch {
    return Promise.resolve(null);
  }
  const found = cache.get(key);
  if (found !== undefined) return found;
  const made = new Promise<Small | null>((done) => queue.push({ specs, done }));
  cache.set(key, made);
  next();
  return made;
}

isIdle.subscribe(() => next());

function next(): void {
  if (busy || !isIdle.peek()) return;
  const job = queue.shift();
  if (job === undefined) return;
  busy = true;
  const end = (made: Small | null) => {
    busy = false;
    job.done(made);
    next();
  };
  small ??= new Pool(1, program());
  small.show({
    recipe: recipeJson(job.specs, SMALL_PX, 1),
    ...withResources(job.specs),
    size: SMALL_PX,
    space: SPACE,
    firstPx: SMALL_PX,
    restMs: null,
    first: end,
    failed: () => end(null),
  });
}

/** What the specs need of dropped files, if anything. */
function withResources(specs: Specs) {
  const { resources } = resourcesOf(specs);
  return resources === undefined ? {} : { resources };
}
