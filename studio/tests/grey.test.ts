import { expect, test } from "vitest";
import { contrastOf, inkOn } from "../src/participant/grey";

test("contrasts are those of WCAG: black on white 21, sRGB 119 on white 4.48", () => {
  expect(contrastOf(0, 255)).toBeCloseTo(21, 5);
  expect(contrastOf(255, 119)).toBeCloseTo(4.48, 2);
  expect(contrastOf(119, 119)).toBe(1);
});

test("words read by 4.5 to 1 on every grey that a study can have", () => {
  for (let code = 0; code <= 255; code += 1) {
    expect(contrastOf(inkOn(code), code)).toBeGreaterThanOrEqual(4.5);
  }
});

test("ink is white on dark greys, and black on the usual and on light ones", () => {
  expect([0, 60, 119, 200, 255].map(inkOn)).toEqual([255, 255, 0, 0, 0]);
});
