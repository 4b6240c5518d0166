// What a knob costs until its new picture, in WebAssembly, beside the native figures, and until its first picture of 512
// and of 256 pixels a side; ms of one thread.
//
//     ./just bench-wasm
//
// `akoya-rg` under `north-window-white`, 512 x 512, one sample a pixel. Nothing here is a test: machines
// differ. The native figures are those of picture.rs, whose file is the argument.

import { readFile } from "node:fs/promises";

import { develop, initSync, Job } from "../target/wasm/nacreous.js";

const RUNS = 5;
const near = (path) => new URL(path, import.meta.url);
const read = async (path) => JSON.parse(await readFile(near(path), "utf8"));

initSync({ module: await readFile(near("../target/wasm/nacreous_bg.wasm")) });
const recipe = await read("../tests/golden/recipes/akoya-rg-north-window-white.json");
Object.assign(recipe, { size: 512, samples: 1 });
const text = () => JSON.stringify(recipe);

const printed = (await readFile(process.argv[2], "utf8")).trim().split("\n");
const native = new Map(printed.map((line) => line.split(",")));

/** Processor time in ms. */
function timed(work) {
  const begin = process.cpuUsage();
  work();
  const { user, system } = process.cpuUsage(begin);
  return (user + system) / 1e3;
}

/** Works out what is missing, and says how long the longest piece took. */
function prepare(job) {
  let [longest, ready] = [0, false];
  while (!ready) longest = Math.max(longest, timed(() => (ready = job.step())));
  return longest;
}

function row(name, ...columns) {
  const widths = [9, 9, 15, 11, 11];
  console.log(name.padEnd(16) + columns.map((text, i) => text.padStart(widths[i])).join(""));
}

/** Prints the least of some runs, and of first pictures. */
function report(name, work, first) {
  let [least, longest] = [Infinity, undefined];
  for (let run = 0; run < RUNS; run++) {
    let piece;
    const ms = timed(() => (piece = work(run)));
    if (ms < least) [least, longest] = [ms, piece];
  }
  const beside = Number(native.get(name)).toFixed(1);
  const previews = first === undefined ? [] : [512, 256].map((px) => leastOf(first, px).toFixed(1));
  row(name, least.toFixed(1), beside, longest?.toFixed(1) ?? "", ...previews);
}

/** The least of some runs after one that fills what is kept. */
function leastOf(work, px) {
  work(0, px);
  return Math.min(...Array.from({ length: RUNS }, (_, run) => timed(() => work(run + 1, px))));
}

row("", "wasm", "native", "longest piece", "first, 512", "first, 256");
report("first", () => {
  const job = new Job(text());
  const longest = prepare(job);
  job.free();
  return longest;
});
const job = new Job(text());
prepare(job);
let pixels;
report("rows", () => void (pixels = job.rows(0, 512)));
job.look(pixels);
report("codes", () => void develop(pixels, "srgb", "soft"));
for (const [name, path, values] of await read("knobs.json")) {
  const [last, ...keys] = path.split("/").slice(1).reverse();
  const section = keys.reduceRight((inner, key) => inner[key], recipe);
  const turn = (run) => {
    section[last] = values[run % 2];
    job.change(text());
  };
  const refine = (run) => (turn(run), prepare(job));
  report(name, refine, (run, px) => (turn(run), job.preview(px, "srgb", "soft")));
}
