// The door to the browser: the same laws and numbers as everywhere else. `./just wasm` builds what
// is tested here, then runs it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { nacreous, near } from "./bundle.mjs";

const { energies, energiesSingle, illuminant, Stack } = nacreous;

const thicknessNm = Float64Array.from({ length: 100 }, (_, i) => 350 + ((i * 37) % 101));
const angleRad = Float64Array.of(0, 0.6, 1.2);
const wavelengthNm = Float64Array.from({ length: 70 }, (_, i) => 400 + 4 * i);
const nacre = (aragonite = 1.53, protein = 1.43) =>
  new Stack(thicknessNm, 20, aragonite, protein, 1, 1.53);

/** The stacks of bilayers among the independent numbers, with what they reflect and transmit. */
function golden() {
  const [, ...rows] = readFileSync(near("../golden/tmm_reference.csv"), "utf8").trim().split("\n");
  return rows
    .map((row) => row.split(","))
    .filter(([name]) => ["one_bilayer", "six_bilayers", "six_bilayers_absorbing"].includes(name))
    .map(([name, polarisation, nm, deg, R, T, indices, thicknesses]) => {
      const index = indices.split(";").map((n) => Float64Array.from(n.replace("j", "").split("+")));
      const bilayers = thicknesses.split(";").slice(1, -1).map(Number);
      const aragoniteNm = bilayers.filter((_, i) => i % 2 === 0);
      const stack = new Stack(aragoniteNm, bilayers[1], index[1], index[2], index[0], index.at(-1));
      const at = [[(deg * Math.PI) / 180], [Number(nm)], polarisation];
      return { name, stack, at, expected: [Number(R), Number(T)] };
    });
}

test("double precision agrees with the independent numbers to 1e-12", () => {
  const cases = golden();
  assert.equal(cases.length, 72);
  for (const { stack, at, expected } of cases) {
    const [R, T] = energies(stack, ...at);
    assert.ok(R instanceof Float64Array);
    assert.ok(Math.abs(R[0] - expected[0]) < 1e-12, `${R[0]} ${expected[0]}`);
    assert.ok(Math.abs(T[0] - expected[1]) < 1e-12, `${T[0]} ${expected[1]}`);
  }
});

test("single precision agrees with the independent numbers of lossless stacks to 1e-6", () => {
  for (const { name, stack, at, expected } of golden()) {
    if (name.endsWith("absorbing")) continue;
    const [R, T] = energiesSingle(stack, ...at);
    assert.ok(R instanceof Float32Array);
    assert.ok(Math.abs(R[0] - expected[0]) < 1e-6, `${R[0]} ${expected[0]}`);
    assert.ok(Math.abs(T[0] - expected[1]) < 1e-6, `${T[0]} ${expected[1]}`);
  }
});

test("R + T is 1 when lossless", () => {
  for (const [compute, most] of [[energies, 1e-12], [energiesSingle, 1e-6]]) {
    const [R, T] = compute(nacre(), angleRad, wavelengthNm, "unpolarised");
    assert.equal(R.length, angleRad.length * wavelengthNm.length);
    assert.ok(R.every((share, i) => Math.abs(share + T[i] - 1) < most));
    assert.ok(R.some((share) => share > 0.2));
  }
});

test("R + T + A is 1 with named, uniaxial and absorbing media", () => {
  for (const media of [
    ["aragonite", "chitin"],
    [Float64Array.of(1.683, 0, 1.53, 0), Float64Array.of(1.43, 0.01)],
  ]) {
    const [R, T, A] = energies(nacre(...media), angleRad, wavelengthNm, "p");
    assert.ok(R.every((share, i) => Math.abs(share + T[i] + A[i] - 1) < 1e-12));
  }
});

test("the polarisations are one at normal incidence and mix to natural light elsewhere", () => {
  const [s, p, both] = ["s", "p", "unpolarised"].map(
    (plane) => energies(nacre(), angleRad, wavelengthNm, plane)[0],
  );
  for (let i = 0; i < both.length; i++) {
    if (i < wavelengthNm.length) assert.ok(Math.abs(s[i] - p[i]) < 1e-12);
    assert.ok(Math.abs((s[i] + p[i]) / 2 - both[i]) < 1e-12);
  }
});

test("one layer lit from within sends what its protein's two faces reflect", () => {
  const stack = new Stack([450], 20, 1.53, 1.43, 1, 1.53);
  const table = illuminant(stack, [0], wavelengthNm, 5000, 0.05, 0.02);
  const [r1, r2] = [(1.53 - 1) / (1.53 + 1), (1.53 - 1.43) / (1.53 + 1.43)];
  wavelengthNm.forEach((nm, i) => {
    const expected = (1 - r1 ** 2) * (2 * r2 * Math.sin((2 * Math.PI * 1.43 * 20) / nm)) ** 2;
    assert.ok(Math.abs(table[i] - expected) < 1e-14, `${table[i]} ${expected}`);
  });
});

test("the example in docs/optics.md runs as shown", async () => {
  const [, example] = readFileSync(near("../../docs/optics.md"), "utf8").match(/```js\n(.*?)```/s);
  const bundle = near("../../target/wasm/nacreous.js").href;
  const program = `${example.replace("./nacreous.js", bundle)}; export { R, T, A }`;
  const shares = await import(`data:text/javascript,${encodeURIComponent(program)}`);
  assert.ok(shares.R instanceof Float32Array);
  assert.ok(shares.R.every((R, i) => Math.abs(R + shares.T[i] + shares.A[i] - 1) < 1e-5));
  assert.equal(shares.R.length, 6);
});

test("a bad value is refused in one line", () => {
  const stack = (...thicknessNm) => () => new Stack(thicknessNm, 20, 1.53, 1.43, 1, 1.53);
  const medium = (...media) => () => nacre(...media);
  const light = (angle, nm, plane) => () => energies(nacre(), [angle], [nm], plane);
  const large = () => energies(nacre(), new Float64Array(8192), new Float64Array(4096), "s");
  const absorbing = nacre(1.53, Float64Array.of(1.43, 0.1));
  const refusals = [
    [stack(400, -1), "thickness_nm[1] is -1; allowed: above 0, up to 1000000 nm"],
    [stack(), "the stack has 0 layers; allowed: 1 to 5000"],
    [medium(NaN), "aragonite: n is NaN; allowed: above 0, up to 100"],
    [medium("chalk"), "aragonite is 'chalk'; allowed: aragonite, aragonite-isotropic-1.53, "],
    [medium(1.53, null), "protein is not a medium; allowed: a name, a number, a Float64Array "],
    [light(2, 550, "s"), "angle_rad is 2; allowed: 0 to pi/2"],
    [light(0, NaN, "s"), "wavelength_nm is NaN; allowed: 1 to 1000000 nm"],
    [light(0, 550, "q"), "polarisation is 'q'; allowed: s, p, unpolarised"],
    [large, "the table has 8192 x 4096 values; allowed: up to 16777216"],
    [() => illuminant(absorbing, [0], [550], 5000, 0.05, 0), "protein has k = 0.1; allowed: 0, "],
  ];
  for (const [question, begin] of refusals) {
    assert.throws(question, ({ name, message }) => {
      assert.equal(name, "Error");
      assert.ok(message.startsWith(begin) && !message.includes("\n"), message);
      return true;
    });
  }
});
