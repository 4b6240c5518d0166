/** A worker: one job, which makes whatever was asked for last. */

import {
  Job,
  develop,
  initSync,
  layers,
  lightOf,
  resolvedKeys,
  tell_panics,
  type RecipeJson,
  type Resources,
  type Shared,
} from "nacreous-wasm";
import { firstPicture } from "./first";
import type {
  Agreed,
  Band,
  FromWorker,
  Light,
  Look,
  Parts,
  Resolve,
  Show,
  ToWorker,
} from "./messages";

/** Rows are made in pieces of some so many ms; between two the worker looks at its messages. */
const PIECE_MS = 20;
/** What comes before is made in so many pieces by all workers: of reflections one takes some 20 ms, of films, which fall into
 * groups of 16 columns, 50. */
const PIECES: Readonly<Record<Shared, number>> = { films: 4, reflections: 16 };

const page = self as unknown as {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker, transfer?: Transferable[]): void;
};

let job: Job | null = null;
/** What was dropped onto the page, as it was last told, and as the job has it. */
let told: Resources | undefined;
let given: Resources | undefined;
let latest: Show | null = null;
let running = false;
let rowsAtOnce = 2;
let firstPx = 512;
/** What the last first picture was of. */
let shown: { readonly recipe?: RecipeJson; readonly resources: Resources | undefined } = {
  resources: undefined,
};
let agreed: Agreed | null = null;
let joined: Parts | null = null;
/** Bands that are this worker's, the next first. */
let bands: Band[] = [];

/** Goes on with whatever waits for a message. */
let wake = () => {};

page.onmessage = ({ data }) => {
  if (data.kind === "load") {
    initSync({ module: data.module });
    tell_panics();
  } else if (data.kind === "show") {
    if (data.resources !== undefined) told = data.resources;
    latest = data;
    if (!running) void work();
  } else if (data.kind === "agreed") {
    agreed = data;
  } else if (data.kind === "parts") {
    joined = data;
  } else if (data.kind === "band") {
    bands.push(data);
  } else {
    answer(data);
  }
  wake();
};

/** Goes on until nothing newer is wanted. */
async function work(): Promise<void> {
  running = true;
  while (latest !== null) {
    const wanted: Show = latest;
    latest = null;
    try {
      await make(wanted);
    } catch (error) {
      fail(wanted.ticket, error);
    }
  }
  running = false;
}

async function make(wanted: Show): Promise<void> {
  const since = performance.now();
  if (wanted.restMs === null && wanted.firstPx === 0) return;
  const resources = told;
  if (job === null) job = new Job(wanted.recipe, resources);
  else job.change(wanted.recipe, resources === given ? undefined : resources);
  given = resources;
  const { recipe } = wanted;
  // It may be asked for again before the page has heard of it.
  if (wanted.firstPx > 0 && !(shown.recipe === recipe && shown.resources === resources)) {
    firstPx = wanted.firstPx;
    shown = { recipe, resources };
    const first = firstPicture(job, wanted.firstPx, wanted.space);
    page.postMessage({ kind: "first", ticket: wanted.ticket, ...first }, [first.codes.buffer]);
  }
  if (wanted.restMs === null || !(await rested(since + wanted.restMs))) return;
  if (!(await share(job, wanted))) return;
  do {
    await messages();
    if (latest !== null) return;
  } while (!job.step());
  if (!(await picture(job, wanted))) return;
  // Made once for nothing, the next first picture finds what the whole one has learnt in its place.
  if (wanted.part === 0) job.preview(firstPx, wanted.space, "soft");
}

/** Works out this worker's pieces of what comes before the rows, and takes the others'; false where something newer came. */
async function share(job: Job, { ticket, part, parts }: Show): Promise<boolean> {
  for (let round = 0; ; round += 1) {
    await messages();
    if (latest !== null) return false;
    page.postMessage({ kind: "lacks", ticket, round, part, shared: job.lacks() ?? null });
    const isThis = (one: Agreed | Parts | null) => one?.ticket === ticket && one.round === round;
    const next = await reply(() => (isThis(agreed) ? agreed : null));
    if (next === null) return false;
    if (next.shared === null) return true;
    const own = await pieces(job, next.shared, [part, parts]);
    if (own === null) return false;
    const buffers = own.map((one) => one.buffer);
    page.postMessage({ kind: "part", ticket, round, part, pieces: own }, buffers);
    const all = await reply(() => (isThis(joined) ? joined : null));
    if (all === null) return false;
    job.join(next.shared, [...all.pieces]);
    joined = null; // a megabyte or two
  }
}

/** Every so-many-th piece of what is shared out; null where something newer came. */
async function pieces(
  job: Job,
  shared: Shared,
  [part, parts]: readonly [number, number],
): Promise<Float64Array<ArrayBuffer>[] | null> {
  const own = [];
  for (let piece = part; piece < PIECES[shared]; piece += parts) {
    own.push(job.part(shared, piece, PIECES[shared]) as Float64Array<ArrayBuffer>);
    await messages();
    if (latest !== null) return null;
  }
  return own;
}

/** Makes bands until none is left; false where something newer came. */
async function picture(job: Job, wanted: Show): Promise<boolean> {
  const { ticket, part } = wanted;
  const ask = () => page.postMessage({ kind: "free", ticket, part });
  bands = [];
  ask(); // one in hand while the other is asked for
  ask();
  for (;;) {
    const band = await reply(() => bands.shift());
    if (band === null) return false;
    if (band.ticket !== ticket) continue;
    if (band.first === band.end) return true;
    ask();
    for (let row = band.first; row < band.end;) {
      row = rows(job, wanted, row, band.end);
      await messages();
      if (latest !== null) return false;
    }
  }
}

/** Waits until a time, in ms of this worker's clock; false where something newer came. */
async function rested(until: number): Promise<boolean> {
  await messages();
  const restMs = until - performance.now();
  if (restMs > 0 && latest === null) {
    await new Promise<void>((go) => {
      const bell = setTimeout(go, restMs);
      wake = () => {
        if (latest === null) return;
        clearTimeout(bell);
        go();
      };
    });
  }
  return latest === null;
}

/** Waits for what the others come to; null where something newer came. */
async function reply<T>(last: () => T | null | undefined): Promise<T | null> {
  for (;;) {
    const found = last();
    if (found) return found;
    if (latest !== null) return null;
    await new Promise<void>((go) => (wake = go));
  }
}

/** Makes some rows, tells them, and gives the next. */
function rows(job: Job, wanted: Show, first: number, least: number): number {
  const end = Math.min(first + rowsAtOnce, least);
  const began = performance.now();
  const pixels = job.rows(first, end);
  const covered = coveredIn(pixels);
  let made;
  let light: Light | null = null;
  if (job.hasGlare) {
    made = new Float32Array(pixels);
  } else {
    job.expose(pixels);
    made = develop(pixels, wanted.space, "soft").codes;
    light = new Float32Array(lightOf(pixels));
  }
  const rowMs = (performance.now() - began) / (end - first);
  rowsAtOnce = Math.max(1, Math.round(PIECE_MS / rowMs));
  const { ticket } = wanted;
  const buffers = [made.buffer, covered.buffer, ...(light === null ? [] : [light.buffer])];
  const told = { kind: "rows", ticket, first, size: job.size, made, covered, light } as const;
  page.postMessage(told, buffers);
  return end;
}

/** Which pixels are a pearl's. */
function coveredIn(pixels: Float32Array): Uint8Array<ArrayBuffer> {
  const parts = layers();
  const step = parts.at(-1)?.end ?? 1;
  const at = parts.find((one) => one.name === "coverage")?.first ?? 0;
  return Uint8Array.from({ length: pixels.length / step }, (_, i) =>
    (pixels[i * step + at] ?? 0) >= 0.5 ? 1 : 0,
  );
}

function answer(asked: Look | Resolve): void {
  try {
    if (asked.kind === "resolve") {
      const keys = resolvedKeys(asked.pearl);
      page.postMessage({ kind: "resolved", question: asked.question, keys });
    } else if (job !== null) {
      job.look(asked.pixels);
      const { codes } = develop(asked.pixels, asked.space, "soft");
      const light = new Float32Array(lightOf(asked.pixels));
      const { ticket } = asked;
      page.postMessage({ kind: "whole", ticket, codes, light }, [codes.buffer, light.buffer]);
    }
  } catch (error) {
    fail(asked.kind === "look" ? asked.ticket : -1, error);
  }
}

function fail(ticket: number, error: unknown): void {
  const text = error instanceof Error ? error.message : String(error);
  if (text.includes("broken off")) job = null; // a fault of ours: that job is of no use any more
  page.postMessage({ kind: "failed", ticket, text });
}

const channel = new MessageChannel();

/** Lets messages come in; a timeout would wait for 4 ms. */
function messages(): Promise<void> {
  return new Promise((go) => {
    channel.port1.onmessage = () => go();
    channel.port2.postMessage(null);
  });
}
