// Exact optics in WebAssembly, one thread: ns per layer x wavelength x angle x polarisation.
//
//     ./just bench-wasm
//
// The job of benchmarks/optics.py with 400 bilayers, at fewer angles: lossless, in single and
// double precision, and how far apart the two are. Nothing here is a test: machines differ.

import { readFile } from "node:fs/promises";

import { energies, energiesSingle, illuminant, initSync, Stack } from "../target/wasm/nacreous.js";

const RUNS = 9;
const BILAYERS = 400;
const ANGLES = 9;

initSync({
  module: await readFile(new URL("../target/wasm/nacreous_bg.wasm", import.meta.url)),
});

/** Thicknesses in nm; the same numbers as in optics.py. */
function grown(bilayers) {
  let state = 1n;
  return Float64Array.from({ length: bilayers }, () => {
    let total = 0;
    for (let i = 0; i < 12; i++) {
      state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
      total += Number(state >> 11n) / 2 ** 53;
    }
    return 450 + 40 * (total - 6);
  });
}

/** Seconds of the best of some runs, and what the last one gave. */
function best(work) {
  let least = Infinity;
  let result;
  for (let run = 0; run < RUNS; run++) {
    const begin = process.cpuUsage();
    result = work();
    const { user, system } = process.cpuUsage(begin);
    least = Math.min(least, (user + system) / 1e6);
  }
  return { seconds: least, result };
}

const angleRad = Float64Array.from({ length: ANGLES }, (_, i) => ((i / ANGLES) * Math.PI) / 2);
const wavelengthNm = Float64Array.from({ length: 401 }, (_, i) => 380 + i);
const stack = new Stack(grown(BILAYERS), 20, 1.53, 1.43, 1, 1.53);
const evaluations = 2 * BILAYERS * angleRad.length * wavelengthNm.length * 2;

function report(name, work) {
  const { seconds, result } = best(work);
  console.log(`${name.padEnd(18)} ${((seconds / evaluations) * 1e9).toFixed(2)} ns`);
  return result;
}

const [single] = report("lossless, single", () =>
  energiesSingle(stack, angleRad, wavelengthNm, "unpolarised"),
);
const [double] = report("lossless", () => energies(stack, angleRad, wavelengthNm, "unpolarised"));
report("illuminant model", () => illuminant(stack, angleRad, wavelengthNm, 5000, 0.05, 0));
for (const wavelengths of [1, 32]) {
  const angles = Float64Array.from({ length: 900 }, (_, i) => i / 600);
  const nm = Float64Array.from({ length: wavelengths }, (_, i) => 400 + i);
  const short = new Stack(new Float64Array(10).fill(400), 20, 1.53, 1.43, 1, 1.53);
  const { seconds } = best(() => illuminant(short, angles, nm, 5000, 0.05, 0));
  console.log(`illuminant model, 900 x ${wavelengths}: ${(seconds * 1e6).toFixed(0)} us`);
}
const apart = double.reduce((most, R, i) => Math.max(most, Math.abs(R - single[i])), 0);
console.log(`largest difference in R of single and double precision: ${apart.toExponential(1)}`);
