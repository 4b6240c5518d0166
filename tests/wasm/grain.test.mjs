// A photograph's grain by WebAssembly: the native one to the last bit, so the same texture. `./just wasm` builds what is
// tested here, has the native grain made, then runs it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import * as files from "../../target/wasm/nacreous_files.js";
import { near } from "./bundle.mjs";

files.initSync({ module: readFileSync(near("../../target/wasm/nacreous_files_bg.wasm")) });

const photograph = readFileSync(near("../../docs/pictures/pearl.png"));

test("a photograph has the grain that Python measures, to the last bit", () => {
  const grain = files.photographedGrain(photograph, 60, 0.012, undefined, undefined);
  const made = Buffer.concat(
    [grain.cyclesPerMm, grain.density, grain.correlation].map((numbers) => Buffer.from(numbers.buffer)),
  );
  const native = readFileSync(near("../../target/wasm-native/grain.f64"));
  assert.ok(Math.max(...grain.density) > 0);
  assert.ok(made.equals(native));
});

test("patches that a photograph has no room for are refused in one line", () => {
  assert.throws(() => files.photographedGrain(photograph, 1000, undefined, undefined, undefined), {
    message: "texture: the photograph has 768 x 768 pixels; allowed: at least side_px = 1000 each way",
  });
});
