/** A worker that answers one request about files, and is then of no more use. */

import * as files from "nacreous-files";
import { Job, difference, initSync, tell_panics } from "nacreous-wasm";
import { withTexts } from "./png";
import type { Answer, Ask, GrainKeys, Kept, Marked, Request, Requests, Saved } from "./requests";

type Answers = { readonly [R in Request]: (given: Requests[R][0]) => Requests[R][1] };

const page = self as unknown as {
  onmessage: ((event: MessageEvent<Ask>) => void) | null;
  postMessage(message: Answer): void;
};

const ANSWERS: Answers = {
  panorama: ({ bytes }) => files.panorama(bytes),
  light: ({ text, place }) => new Float64Array(files.measuredLight(text, place)),
  grain: ({ bytes, how }) => grain(bytes, how),
  exr: ({ bytes }) => files.openExr(bytes),
  pngTexts: ({ bytes }) => files.pngTexts(bytes),
  save,
  mark,
  codes: ({ rgb, space }) => files.codesOf(rgb, space, "soft"),
  difference: ({ first, second, covered, space }) =>
    difference(new Uint8Array(first.buffer), new Uint8Array(second.buffer), covered, space),
};

page.onmessage = ({ data }) => {
  try {
    if (data.program !== null) {
      initSync({ module: data.program });
      tell_panics();
    }
    if (data.files !== null) files.initSync({ module: data.files });
    const answer = ANSWERS[data.kind] as (given: unknown) => Requests[Request][1];
    page.postMessage({ ok: true, value: answer(data.given) });
  } catch (error) {
    page.postMessage({ ok: false, text: said(error) });
  }
};

/** A trap has no words: memory ran out. */
function said(error: unknown): string {
  if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) {
    return "takes more memory than this page has";
  }
  return error instanceof Error ? error.message : String(error);
}

function grain(bytes: Uint8Array, how: GrainKeys): files.Grain {
  const [low, high] = [how.low_per_mm ?? undefined, how.high_per_mm ?? undefined];
  return files.photographedGrain(bytes, how.side_px, how.mm_per_pixel ?? undefined, low, high);
}

/** Renders a picture, whole, and writes it with all its layers. */
function save({ recipe, resources, ...kept }: Saved): Uint8Array<ArrayBuffer> {
  const job = new Job(recipe, resources);
  const pixels = job.rows(0, job.size);
  job.look(pixels);
  const written = keptTexts(kept, job.size).flat();
  return new Uint8Array(files.writeExr(job.size, pixels, written));
}

/** How the page's codes are made of light: worker.ts. */
function mark({ png, space, size, ...kept }: Marked): Uint8Array<ArrayBuffer> {
  const developed = `{"bits": 8, "space": "${space}", "gamut": "soft", "alpha": false}`;
  return withTexts(png, [...keptTexts(kept, size), ["nacreous:developed", developed]]);
}

/** What a file of ours says of its recipe: `recipe.py` `texts`. */
function keptTexts({ samples, pearls, texts }: Kept, size: number): [string, string][] {
  const one = (values: readonly string[]) =>
    values.length === 1 ? String(values[0]) : `[${values.join(", ")}]`;
  const seeds = one(pearls.map((pearl) => pearl.seed));
  const grains = one(pearls.map((pearl) => String(files.textureSeed(pearl.json))));
  const settings =
    `{"size": ${size}, "samples": ${samples}, ` + `"seed": ${seeds}, "texture_seed": ${grains}}`;
  const all = [
    ...texts,
    ["settings", settings],
    ["versions", `{"nacreous": "${files.version()}"}`],
  ];
  return all.map(([keyword, text]) => [`nacreous:${keyword}`, text ?? ""]);
}
