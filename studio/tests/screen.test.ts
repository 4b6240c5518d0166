import { expect, test } from "vitest";
import { across_mm, CARD_MM } from "../src/participant/screen/card";
import { stepsOf } from "../src/participant/screen/check";
import { code, confusedWith } from "../src/participant/screen/confusion";
import { agent } from "../src/participant/screen/content";
import { codeOf, CONTRASTS } from "../src/participant/screen/contrast";
import { distance_mm, median, plausible, wideEnough } from "../src/participant/screen/distance";
import { gammaOf } from "../src/participant/screen/levels";
import { LEVEL, platesOf, SHARES, SPREAD } from "../src/participant/screen/plates";

test("a grey of 186 matches stripes on a screen of gamma 2.2", () => {
  expect(gammaOf(186)).toBeCloseTo(2.197, 3);
  expect((186 / 255) ** gammaOf(186)).toBeCloseTo(0.5);
  expect(gammaOf(128)).toBeCloseTo(1.006, 3);
});

test("the blind spot 144 mm from the line of sight means 60 cm", () => {
  expect(distance_mm(144.05)).toBeCloseTo(600, 0);
  expect(median([700, 590, 610])).toBe(610);
  expect(median([600, 700])).toBe(650);
});

test("a distance is doubted outside the study's limits alone", () => {
  const limits = { least_distance_mm: 200, most_distance_mm: 2000 };
  const found = [0, 199.9, 200, 600, 2000, 2000.1, NaN].map((mm) => plausible(mm, limits));
  expect(found).toEqual([false, false, true, true, true, false, false]);
});

test("a telephone held upright is too narrow for the blind spot, a laptop is not", () => {
  expect(wideEnough(390, 6)).toBe(false);
  expect(wideEnough(1280, 4.2)).toBe(true);
});

test("on a narrow or a low window the card is held upright", () => {
  const { width, height } = CARD_MM;
  expect([across_mm(390, 844), across_mm(1280, 800)]).toEqual([height, width]);
  expect(across_mm(844, 390)).toBe(height); // a telephone on its side is low
});

test("rings are darker than the surround by their contrast, and never as bright", () => {
  for (const grey of [60, 119, 255]) {
    for (const gamma of [1.6, 2.2, 2.8]) {
      const codes = CONTRASTS.map((contrast) => codeOf(contrast, gamma, grey));
      expect(Math.max(...codes)).toBeLessThan(grey);
      expect(codes).toEqual([...codes].sort((one, other) => one - other));
    }
    expect((codeOf(0.5, 2.2, grey) / grey) ** 2.2).toBeCloseTo(0.5, 1);
  }
});

/** Viénot, Brettel and Mollon 1999, written anew. */
function cones([r, g, b]: readonly [number, number, number]) {
  return [
    17.8824 * r + 43.5161 * g + 4.11935 * b,
    3.45565 * r + 27.1554 * g + 3.86714 * b,
    0.0299566 * r + 0.184309 * g + 1.46709 * b,
  ] as const;
}

test("a plate's colours differ in one kind of cones alone", () => {
  const grey = cones([0.3, 0.3, 0.3]);
  const protan = cones(confusedWith(0.3, "protan", 0.2));
  const deutan = cones(confusedWith(0.3, "deutan", -0.2));
  expect(protan[0] / grey[0]).toBeCloseTo(1.2);
  expect([protan[1], protan[2]]).toEqual([expect.closeTo(grey[1]), expect.closeTo(grey[2])]);
  expect(deutan[1] / grey[1]).toBeCloseTo(0.8);
  expect([deutan[0], deutan[2]]).toEqual([expect.closeTo(grey[0]), expect.closeTo(grey[2])]);
});

test("a plate's colours are within what a screen shows", () => {
  for (const missing of ["protan", "deutan"] as const) {
    for (const share of [SHARES[missing], -SHARES[missing]]) {
      for (const level of [(1 - SPREAD) * LEVEL, (1 + SPREAD) * LEVEL]) {
        for (const light of confusedWith(level, missing, share)) {
          expect(light).toBeGreaterThanOrEqual(0);
          expect(light).toBeLessThanOrEqual(1);
        }
      }
    }
  }
  expect([0, 0.2158605, 1].map(code)).toEqual([0, 128, 255]);
});

test("the same person has the same plates, each with another digit", () => {
  const plates = platesOf(7);
  expect(platesOf(7)).toEqual(plates);
  expect(platesOf(8).map(({ digit }) => digit)).not.toEqual(plates.map(({ digit }) => digit));
  expect(new Set(plates.map(({ digit }) => digit)).size).toBe(plates.length);
});

test("of a browser its family and version are kept, and nothing else", () => {
  const chromium =
    "Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/156.0.0.0 Safari/537.36";
  expect(agent(chromium)).toBe("Chromium 156");
  expect(agent(`${chromium} Edg/155.0.1`)).toBe("Edge 155");
  expect(agent("Mozilla/5.0 (Macintosh) Gecko/20100101 Firefox/140.0")).toBe("Firefox 140");
  expect(agent("Mozilla/5.0 (Macintosh) AppleWebKit/605 Version/19.1 Safari/605.1.15")).toBe(
    "Safari 19",
  );
  expect(agent("curl/8")).toBe("another browser");
});

test("the check has the steps that a study asks for", () => {
  const rules = {
    least_width_px: 1024,
    least_height_px: 640,
    if_smaller: "flag",
    full_screen: true,
    card: true,
    distance: false,
    levels: true,
    vision: ["colour"],
  } as const;
  const asked = { ...rules, vision: [...rules.vision] };
  expect(stepsOf(asked, true)).toEqual(["full", "card", "gamma", "dark", "colour"]);
  expect(stepsOf(asked, false)).toEqual(["card", "gamma", "dark", "colour"]);
});
