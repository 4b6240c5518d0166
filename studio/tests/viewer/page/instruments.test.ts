import { expect, test } from "vitest";
import { dayAfter, outer } from "../../../src/viewer/state/growing";
import { lines, shown } from "../../../src/viewer/state/measured";
import { closeUp, endOf, middleOf, pairs, spotOf } from "../../../src/viewer/state/wheel";

const exact = (value: number) => ({ value, error: null });

test("a number is shown to the second digit of its error, as the command line has it", () => {
  expect(shown({ value: 8.01234, error: 0.0123 }, "mm")).toBe("8.012 ± 0.012 mm");
  expect(shown(exact(0.5), "%", 1)).toBe("0.5 %");
  expect(shown({ value: 311.06, error: 5.94 }, "°")).toBe("311.1 ± 5.9°");
  expect(shown({ value: 250.4, error: 123 }, "px")).toBe("250 ± 123 px");
  expect(shown({ value: 0, error: 0 }, "%")).toBe("0.0 ± 0.0 %");
  expect(shown(exact(3), "")).toBe("3");
  expect(lines([["R", 0.25, null], ["T"]])).toBe("R\t0.25\t\nT");
});

test("days go on through leap days, and through years that nobody named", () => {
  expect(dayAfter("2024-02-28", 1)).toBe("2024-02-29");
  expect(dayAfter("2023-12-31", 1)).toBe("2024-01-01");
  expect(dayAfter("02-28", 1)).toBe("03-01");
  expect(dayAfter("12-31", 1)).toBe("01-01");
});

test("layers lie below each other with protein between, down to a depth", () => {
  const known = {
    thicknessNm: Float64Array.of(400, 600, 500),
    proteinNm: 20,
    seeding: "2024-05-01",
    filmUm: 1,
    grown: { day: Uint32Array.of(10, 9, 9), warmth: Float64Array.of(0.5, 0.4, 0.4) },
  };
  expect(outer(known).map((one) => one.depthUm)).toEqual([0.2, 0.72, 1.29]);
  expect(outer(known, 1).map((one) => one.date)).toEqual(["2024-05-11", "2024-05-10"]);
  const [listed] = outer({ ...known, seeding: "", grown: null });
  expect(listed).toEqual({ depthUm: 0.2, thicknessNm: 400, date: "", warmth: 0 });
});

test("a ring lies in the wheel by hue and chroma, and the wheel holds all rings", () => {
  const ring = (chroma: number, hue: number | null) => ({
    from: 0,
    to: 0.12,
    view_deg: 3,
    share: 1,
    colour: {
      lightness: exact(70),
      chroma: exact(chroma),
      hue_deg: hue === null ? null : exact(hue),
    },
  });
  expect([endOf([]), endOf([4.9, 5.1]), endOf([500])]).toEqual([2, 10, 500]);
  const spot = spotOf(ring(5, 90), 10);
  expect([spot?.x, spot?.y]).toEqual([expect.closeTo(0, 12), 0.5]);
  expect(spotOf(ring(0.2, null), 2)).toEqual({ x: 0.1, y: 0 });
  expect(spotOf({ ...ring(5, 0), colour: null }, 10)).toBeNull();
});

test("the close-up shows the pixels and the white, and black pixels have no place", () => {
  const spots = pairs(Float64Array.of(0.3, 0.3, 0.34, 0.36, NaN, NaN));
  const white = { x: 0.3127, y: 0.329 };
  const { x, y, side } = closeUp(spots, white);
  for (const one of [...spots.slice(0, 2), white]) {
    expect(one.x > x && one.x < x + side && one.y > y && one.y < y + side).toBe(true);
  }
  expect(middleOf(spots)).toEqual({ x: expect.closeTo(0.32, 12), y: expect.closeTo(0.33, 12) });
  expect(middleOf(spots.slice(2))).toBeNull();
  expect(closeUp([], white).side).toBe(0.02);
});
