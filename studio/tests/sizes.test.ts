import { expect, test } from "vitest";
import type { Picture } from "../src/participant/api";
import { drawn, NOMINAL_PX_PER_MM, pxPerMm, shrinkage } from "../src/participant/sizes";

const crop: Picture = { width_px: 128, height_px: 128, width_mm: 50 };
const tall: Picture = { width_px: 100, height_px: 300, width_mm: 20 };

test("a picture is as wide on the screen as the study says", () => {
  const scale = { measured: 4.5, ratio: 1 };
  expect(drawn(crop, pxPerMm(scale, 1), 1)).toEqual({ width_px: 225, height_px: 225 });
  expect(drawn(tall, pxPerMm(scale, 1), 1)).toEqual({ width_px: 90, height_px: 270 });
});

test("zooming the page leaves it as wide in millimetres", () => {
  const scale = { measured: 4, ratio: 1 };
  // At 150 % a CSS pixel is half as large again.
  expect(pxPerMm(scale, 1.5) * 1.5).toBeCloseTo(4);
});

test("without a card sizes are nominal, and right to each other", () => {
  const px_per_mm = pxPerMm({ measured: null, ratio: 2 }, 2);
  expect(px_per_mm).toBe(NOMINAL_PX_PER_MM);
  const [one, other] = [drawn(crop, px_per_mm, 1), drawn(tall, px_per_mm, 1)];
  expect(one.width_px / other.width_px).toBeCloseTo(50 / 20);
});

test("pictures that fit are not shrunk", () => {
  expect(shrinkage([crop, tall], 4, { width_px: 1200, height_px: 700 })).toBe(1);
  expect(shrinkage([], 4, { width_px: 1200, height_px: 700 })).toBe(1);
});

test("all pictures shrink together until the two widest and the highest fit", () => {
  const room = { width_px: 390, height_px: 200 };
  const shrunk = shrinkage([crop, crop, tall], 4, room);
  const [wide, high] = [drawn(crop, 4, shrunk), drawn(tall, 4, shrunk)];
  expect(2 * wide.width_px + 12).toBeLessThanOrEqual(room.width_px);
  expect(high.height_px).toBeLessThanOrEqual(room.height_px + 1e-9);
  expect(wide.width_px / high.width_px).toBeCloseTo(50 / 20);
});
