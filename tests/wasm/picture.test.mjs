// Pictures by WebAssembly: the native ones to one code in each channel of each pixel. `./just wasm`
// builds what is tested here, has the native pictures made, then runs it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { test } from "node:test";

import { nacreous, near } from "./bundle.mjs";

const { Job, Stack, develop, energies, filmSpectra, grow, layers, resolvedKeys } = nacreous;

const CHANNELS = 17;
const NAMES = ["paper-paper", "akoya-rg-north-window-white", "tahitian-north-window-black"];
const AKOYA = NAMES[1];
/** The film's cost, not what is tested with it. */
const FEW = { "pearls.0.film.columns": 8 };

const json = (name) => readFileSync(near(`../golden/recipes/${name}.json`), "utf8");
const native = (file) => readFileSync(near(`../../target/wasm-native/${file}`));

/** A golden recipe with some values changed, by dotted paths. */
function recipe(name = AKOYA, changes = {}) {
  const made = JSON.parse(json(name));
  for (const [path, value] of Object.entries(changes)) {
    const keys = path.split(".");
    const last = keys.pop();
    keys.reduce((inner, key) => inner[key], made)[last] = value;
  }
  return made;
}
const text = (...given) => JSON.stringify(recipe(...given));

/** The whole picture after the look. */
function picture(job) {
  const pixels = job.rows(0, job.size);
  job.look(pixels);
  return pixels;
}

const same = (a, b) => Buffer.compare(Buffer.from(a.buffer), Buffer.from(b.buffer)) === 0;

for (const name of NAMES) {
  test(`${name} has the native picture's codes to one, in both spaces`, (t) => {
    const job = new Job(json(name));
    const pixels = picture(job);
    const bytes = native(`${name}.f32`);
    const expected = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
    assert.equal(pixels.length, expected.length);
    const most = (numbers) => numbers.reduce((a, b) => Math.max(a, b), 0);
    const apart = most(pixels.map((value, i) => Math.abs(value - expected[i])));
    t.diagnostic(`linear values up to ${most(expected).toFixed(2)} differ by at most ${apart.toExponential(1)}`);
    for (const space of ["srgb", "display-p3"]) {
      const { codes, outOfGamut } = develop(pixels, space, "soft");
      assert.ok(codes instanceof Uint8ClampedArray);
      assert.ok(outOfGamut >= 0 && outOfGamut <= 1);
      const rgb = codes.filter((_, i) => i % 4 !== 3);
      assert.ok(codes.every((code, i) => i % 4 !== 3 || code === 255));
      const wanted = native(`${name}.${space}`);
      assert.equal(rgb.length, wanted.length);
      const steps = rgb.map((code, i) => Math.abs(code - wanted[i]));
      t.diagnostic(`${space}: ${steps.filter((step) => step > 0).length} of ${rgb.length} codes differ`);
      assert.ok(most(steps) <= 1, `${most(steps)}`);
    }
  });
}

test("rows asked for by range are those of the whole picture, and two jobs give the same bytes", () => {
  const [job, other] = [new Job(text(AKOYA, FEW)), new Job(text(AKOYA, FEW))];
  const whole = job.rows(0, 24);
  assert.equal(whole.length, 24 * 24 * CHANNELS);
  const ranges = [[5, 6], [0, 5], [6, 24], [24, 99], [9, 3]];
  const parts = ranges.map(([first, end]) => other.rows(first, end));
  assert.deepEqual(parts.map((rows) => rows.length / 24 / CHANNELS), [1, 5, 18, 0, 0]);
  const joined = new Float32Array(whole.length);
  parts.slice(0, 3).forEach((rows, i) => joined.set(rows, ranges[i][0] * 24 * CHANNELS));
  assert.ok(same(joined, whole));
});

test("a job in pieces gives the bytes of one at once, and has no piece left then", () => {
  const [job, other] = [new Job(text(AKOYA, FEW)), new Job(text(AKOYA, FEW))];
  let pieces = 1;
  while (!job.step()) pieces++;
  assert.ok(pieces > 3, `${pieces}`);
  assert.ok(job.step());
  assert.ok(same(picture(job), picture(other)));
});

test("a job that was changed gives the bytes of a new one", () => {
  const job = new Job(text(AKOYA, FEW));
  picture(job);
  for (const change of [
    { "scene.camera.azimuth_deg": 30 },
    { "pearls.0.body.pigment": "gold" },
    { "pearls.0.nacre.harvest": "2024-11-20" },
    { "scene.camera.glare": 0.2 },
    { size: 16 },
  ]) {
    const changed = text(AKOYA, { ...FEW, ...change });
    job.change(changed);
    assert.ok(same(picture(job), picture(new Job(changed))), JSON.stringify(change));
  }
});

test("the look is exposure and glare, and without glare rows alone have it", () => {
  const plain = new Job(text("paper-paper", { "scene.camera.glare": 0, "scene.camera.exposure": 0.5 }));
  assert.equal(plain.hasGlare, false);
  const whole = picture(plain);
  const rows = plain.rows(7, 9);
  plain.expose(rows);
  assert.ok(same(rows, whole.slice(7 * 24 * CHANNELS, 9 * 24 * CHANNELS)));
  assert.equal(new Job(text("paper-paper", { "scene.camera.glare": 0.1 })).hasGlare, true);
});

test("the layers name all numbers of a pixel, and the first four are its light", () => {
  const parts = layers();
  assert.deepEqual(
    parts.map(({ name }) => name),
    ["interference", "diffuse", "mirror", "surroundings", "texture", "coverage", "shadow"],
  );
  assert.deepEqual(parts.map(({ first }) => first), [0, ...parts.slice(0, -1).map(({ end }) => end)]);
  assert.equal(parts.at(-1).end, CHANNELS);
  const pixel = (number) => Float32Array.from({ length: CHANNELS }, (_, i) => (i === number ? 1 : 0));
  const codes = (number) => [...develop(pixel(number), "srgb", "clip").codes];
  assert.deepEqual(codes(parts[3].first), [255, 0, 0, 255]);
  assert.deepEqual(codes(parts[4].first), [0, 0, 0, 255]);
});

test("layers as they grew are those of the stack, the other way round", () => {
  const nacre = JSON.stringify(recipe().pearls[0].nacre);
  const { day, thicknessNm } = grow(nacre);
  assert.equal(day.length, thicknessNm.length);
  assert.ok(day.every((_, i) => i === 0 || day[i] >= day[i - 1]));
  assert.deepEqual([...thicknessNm].reverse(), [...Stack.ofNacre(nacre).thicknessNm]);
});

test("a film of columns all alike, through all layers, is the exact stack", () => {
  const film = { columns: 2, column_spread_nm: 0, outer_um: 500 };
  const thickness_nm = Array.from({ length: 60 }, (_, i) => 380 + ((i * 37) % 51));
  const nacre = { protein_nm: 20, aragonite: 1.53, protein: 1.43, thickness_nm };
  const [pearl] = recipe(AKOYA, { "pearls.0.film": film, "pearls.0.nacre": nacre }).pearls;
  const at = [Float64Array.of(0, 0.7), Float64Array.of(450, 550, 650)];
  const [R, T] = filmSpectra(JSON.stringify(pearl), ...at);
  const [wanted] = energies(Stack.ofNacre(JSON.stringify(nacre)), ...at, "unpolarised");
  assert.equal(R.length, 6);
  assert.ok(R.every((share, i) => Math.abs(share - wanted[i]) < 1e-12));
  assert.ok(R.every((share, i) => Math.abs(share + T[i] - 1) < 1e-12));
});

test("the keys that a pearl leaves open are told with their values", () => {
  const [pearl] = recipe(AKOYA, { "pearls.0.film.outer_um": null }).pearls;
  const open = resolvedKeys(JSON.stringify(pearl));
  assert.ok(open["film.outer_um"] > 1 && open["inside.spread"] > 0);
  const given = resolvedKeys(JSON.stringify({ ...pearl, film: { ...pearl.film, outer_um: 12 } }));
  assert.equal(given["film.outer_um"], 12);
});

test("a light, a panorama and a grain that were handed over are seen", () => {
  const plain = picture(new Job(json("paper-paper")));
  const handed = (changes, resources) =>
    picture(new Job(text("paper-paper", changes), resources));
  const lamp = { "scene.lamps.0.spectrum": "lamp.csv", "scene.camera.white": "D65" };
  const red = Float64Array.from({ length: 401 }, (_, i) => (i > 220 ? 1 : 0));
  const flat = new Float64Array(401).fill(1);
  const [warm, even] = [red, flat].map((light) => handed(lamp, { spectra: { "lamp.csv": light } }));
  assert.ok(!same(warm, even));
  const sky = { ...recipe("paper-paper").scene.sky, kind: "panorama", path: "hall.hdr" };
  const hall = (light) => ({ name: "hall.hdr", width: 2, height: 1, rgb: new Float32Array(6).fill(light) });
  const [dark, lit] = [0, 3].map((light) =>
    handed({ "scene.sky": sky, "scene.table.kind": "none" }, { panoramas: [hall(light)] }),
  );
  assert.ok(!same(dark, lit));
  // Coarse enough for 24 pixels.
  const cyclesPerMm = Float64Array.of(0.2, 0.4, 0.6);
  const density = Float64Array.of(0, 0.1, 0, 0, 0.1, 0, 0, 0.1, 0);
  const correlation = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
  const photograph = { "pearls.0.texture.source": "pearl.png", "pearls.0.grain": 1, "pearls.0.texture.hue_weight": 1 };
  const grained = handed(photograph, { grains: [{ pearl: 0, cyclesPerMm, density, correlation }] });
  assert.ok(!same(plain, grained));
});

test("resources stay with a job until others are handed over", () => {
  const lamp = (file) => text("paper-paper", { "scene.lamps.0.spectrum": file });
  const light = new Float64Array(401).fill(1);
  const job = new Job(json("paper-paper"), { spectra: { "a.csv": light, "b.csv": light } });
  job.change(lamp("a.csv"));
  assert.equal(job.rows(0, 1).length, 24 * CHANNELS);
  job.change(lamp("b.csv"), {});
  assert.throws(() => job.rows(0, 1), { message: /^b\.csv: its contents were not handed over/ });
});

test("what cannot be is refused in one line, and the job goes on", () => {
  const job = new Job(json("paper-paper"));
  const before = picture(job);
  const changed = (changes) => () => job.change(text("paper-paper", changes));
  const made = (resources) => () => new Job(json("paper-paper"), resources);
  const hall = { name: "hall", width: 2, height: 1 };
  const listed = { protein_nm: 20, aragonite: 1.53, protein: 1.43, thickness_nm: [400] };
  const refusals = [
    [() => job.change("{"), "recipe: EOF while parsing"],
    [() => job.change(text("paper-paper", { sise: 1 })), "recipe: unknown field `sise`"],
    [changed({ "pearls.0.diameter_mm": -1 }), "pearls.0.diameter_mm is -1; allowed: 1 to 30 mm"],
    [() => resolvedKeys(JSON.stringify({ ...recipe().pearls[0], depth: 2 })), "pearl.depth is 2; allowed: 0 to 1"],
    [() => Stack.ofNacre(JSON.stringify({ ...listed, protein_nm: -1 })), "nacre.protein_nm is -1; allowed: 0 to 200 nm"],
    [changed({ size: 0 }), "size is 0; allowed: a whole number from 1 to 8192"],
    [changed({ samples: 15 }), "samples is 15; allowed: a square number from 1 to 1024"],
    [made({ spectra: { "a.csv": new Float64Array(3) } }), "spectrum has 3 samples; allowed: 401"],
    [made({ spectra: { "a.csv": [1, 2] } }), "a.csv is not a Float64Array"],
    [made({ panoramas: [{ ...hall, rgb: new Float32Array(5) }] }), "panorama hall is 5 numbers"],
    [made({ panoramas: [{ ...hall, rgb: new Float32Array(6).fill(NaN) }] }), "panorama hall: a value is NaN"],
    [made({ panoramas: hall }), "panoramas is not an array"],
    [made({ grains: [{ pearl: -1 }] }), "grains.pearl is not a whole number from 0"],
    [made(7), "spectra: there is no object"],
    [() => job.look(new Float32Array(16)), "pixels has 16 numbers; allowed: 9792, all of a picture"],
    [() => job.expose(new Float32Array(15)), "pixels has 15 numbers; allowed: a multiple of 17"],
    [() => develop(new Float32Array(15), "srgb", "soft"), "pixels has 15 numbers"],
    [() => develop(new Float32Array(17), "adobe", "soft"), 'RGB space is "adobe"; allowed: srgb, display-p3'],
    [() => develop(new Float32Array(17), "srgb", "hard"), 'gamut is "hard"; allowed: clip, soft'],
    [() => grow(JSON.stringify(listed)), "nacre.thickness_nm lists the layers"],
    [() => filmSpectra(JSON.stringify(recipe("paper-paper").pearls[0]), [0], [550]), 'model is "illuminant"'],
    [() => filmSpectra(JSON.stringify(recipe().pearls[0]), [2], [550]), "angle_rad is 2; allowed: 0 to pi/2"],
  ];
  for (const [question, begin] of refusals) {
    assert.throws(question, ({ name, message }) => {
      assert.equal(name, "Error", message);
      assert.ok(message.startsWith(begin) && !message.includes("\n"), message);
      return true;
    });
  }
  assert.ok(same(picture(job), before));
});

test("a picture that no page's memory holds is refused before it is begun", () => {
  const job = new Job(text("paper-paper", { size: 8192 }));
  assert.throws(() => job.rows(0, 8192), { message: /^rows 0 to 8192 have 67108864 pixels; allowed: up to/ });
});

test("the bundle carries no codec, no threads and no source of chance", () => {
  const tree = ["tree", "--package=nacreous-wasm", "--target=wasm32-unknown-unknown", "--edges=normal", "--prefix=none"];
  const crates = execFileSync("cargo", tree, { cwd: fileURLToPath(near("../..")), encoding: "utf8" });
  const names = new Set(crates.split("\n").map((line) => line.split(" ")[0]));
  assert.ok(names.has("nacreous-render"));
  for (const name of ["rayon", "getrandom", "png", "exr", "image", "moxcms", "nacreous-file"]) {
    assert.ok(!names.has(name), name);
  }
});

test("the example in docs/browser.md runs as shown", async () => {
  const folder = mkdtempSync(join(tmpdir(), "nacreous-"));
  try {
    const [, example] = readFileSync(near("../../docs/browser.md"), "utf8").match(/```js\n(.*?)```/s);
    for (const file of ["nacreous.js", "nacreous_bg.wasm"]) {
      copyFileSync(near(`../../target/wasm/${file}`), join(folder, file));
    }
    copyFileSync(near("../../target/wasm-native/presets.json"), join(folder, "presets.json"));
    writeFileSync(join(folder, "example.mjs"), example);
    execFileSync(process.execPath, ["example.mjs"], { cwd: folder, stdio: "pipe" });
    const picture = readFileSync(join(folder, "pearl.ppm"));
    assert.equal(picture.length, "P6 64 64 255\n".length + 3 * 64 * 64);
    assert.ok(new Set(picture).size > 50);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
