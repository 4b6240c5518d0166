// The instruments' numbers by WebAssembly: what is measured in a picture, what a pixel sees, where
// colours lie. `./just wasm` builds what is tested here, then runs it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { nacreous, near } from "./bundle.mjs";

const { Job, chromaticities, codesOfLab, filmSpectra, grow, lightOf, measure } = nacreous;
const { primariesOf, spectralLocus } = nacreous;

const text = readFileSync(near("../golden/recipes/akoya-rg-north-window-white.json"), "utf8");
const recipe = { ...JSON.parse(text), size: 65 };
recipe.pearls[0].film.columns = 2;
const [pearl] = recipe.pearls;

/** A bright disc on dark ground, without a lamp. */
function disc(side, radius) {
  const light = (_, i) => {
    const at = Math.floor(i / 3);
    const away = Math.hypot((at % side) + 0.5 - side / 2, Math.floor(at / side) + 0.5 - side / 2);
    return 0.05 + 0.6 * Math.min(1, Math.max(0, radius + 0.5 - away));
  };
  return Float32Array.from({ length: 3 * side * side }, light);
}

test("a disc has its size, in pixels and in mm, and what is not there is refused by name", () => {
  const found = measure(disc(64, 20), 64, 64);
  assert.ok(Math.abs(found.size.mean.value - 40) < 0.1);
  assert.equal(found.size.unit, "px");
  assert.equal(found.lamp, null);
  assert.equal(found.refused[0].quantity, "lamp");
  const inMm = measure(disc(64, 20), 64, 64, 0.1, Float64Array.of(32, 32, 20));
  assert.ok(Math.abs(inMm.size.mean.value - 4) < 0.01 && inMm.place.given);
  assert.throws(() => measure(disc(64, 0), 64, 64), /^Error: no pearl/);
  assert.throws(() => measure(disc(64, 20), 64, 64, 0.1, Float64Array.of(1)), /circle has 1 /);
  assert.throws(() => measure(disc(64, 20), 63, 64));
});

test("a pixel sees the pearl at an angle whose sine is its distance from the middle", () => {
  const job = new Job(JSON.stringify(recipe));
  assert.ok(job.sight(32, 32).viewRad < 1e-6);
  const sine = (10 * job.mmPerPixel) / (pearl.diameter_mm / 2);
  assert.ok(Math.abs(Math.sin(job.sight(32, 42).viewRad) / sine - 1) < 0.05);
  assert.equal(job.sight(32, 42).pearl, 0);
  assert.equal(job.sight(0, 0), undefined);
});

test("a job tells of its pearls what the functions of pearls tell", () => {
  const job = new Job(JSON.stringify(recipe));
  const asked = [Float64Array.of(0.4), Float64Array.of(450, 550, 650)];
  assert.deepEqual(job.filmSpectra(0, ...asked), filmSpectra(JSON.stringify(pearl), ...asked));
  const grown = job.grow(0);
  assert.deepEqual(grown, grow(JSON.stringify(pearl.nacre)));
  assert.deepEqual(job.thicknessNm(0), grown.thicknessNm.slice().reverse());
  assert.ok(grown.warmth.every((warmth) => warmth >= 0 && warmth <= 1));
  assert.throws(() => job.grow(1), /pearl is 1; allowed: 0 to 0/);
});

test("sRGB lies within what can be seen, and grey where white does", () => {
  const srgb = primariesOf("srgb");
  const known = [0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329];
  assert.ok(srgb.every((value, i) => Math.abs(value - known[i]) < 1e-6));
  const locus = spectralLocus();
  assert.equal(locus.length, 2 * 401);
  assert.ok(Math.max(...locus.filter((_, i) => i % 2 === 0)) > 0.73); // red's end
  const [x, y] = chromaticities(Float32Array.of(0.3, 0.3, 0.3));
  assert.ok(Math.abs(x - 0.3127) < 1e-6 && Math.abs(y - 0.329) < 1e-6);
  const white = codesOfLab(Float64Array.of(100, 0, 0), "srgb", "clip");
  assert.deepEqual([...white], [255, 255, 255, 255]);
  assert.deepEqual([...lightOf(new Float32Array(17).fill(0.25))], [1, 1, 1]);
});
