import { crc32 } from "node:zlib";
import { expect, test } from "vitest";
import { PEARLS, SCENES, declarations } from "../../../src/viewer/specs/spec";
import { around, lights, moved, turned, zoomed } from "../../../src/viewer/state/camera";
import { dayOf, dayOfYear, onDay, written } from "../../../src/viewer/state/dates";
import { begin, redone, step, undone } from "../../../src/viewer/state/history";
import { changes, declared, valueAt, withValue } from "../../../src/viewer/state/path";
import { pressed, scaleOf } from "../../../src/viewer/state/scale";
import { studyOf } from "../../../src/viewer/state/study";
import { numberOf } from "../../../src/viewer/state/typed";
import { withTexts } from "../../../src/viewer/light/png";
import { wordFor } from "../../../src/viewer/state/trade";
import { directionOf, placeOf } from "../../../src/viewer/panels/Dome";

const pearl = PEARLS.get("akoya-rg")!;
const scene = SCENES.get("north-window-black")!;

test("a value is set by its path, and nothing else is", () => {
  const next = withValue(scene, "windows.0.azimuth_deg", 10);
  expect(valueAt(next, "windows.0.azimuth_deg")).toBe(10);
  expect(valueAt(scene, "windows.0.azimuth_deg")).toBe(-75);
  expect(next.camera).toBe(scene.camera);
  expect(changes(scene, next)).toEqual([{ path: "windows.0.azimuth_deg", from: -75, to: 10 }]);
  expect(valueAt(pearl, "nacre.nothing.at.all")).toBeUndefined();
  expect([declared("lamps.12.azimuth_deg"), declared("depth")]).toEqual([
    "lamps.azimuth_deg",
    "depth",
  ]);
});

test("a gesture is one step, and steps are undone and redone in order", () => {
  let history = begin(0);
  history = step(history, 1, "depth", 0);
  history = step(history, 2, "depth", 100);
  history = step(history, 3, "grain", 200);
  expect([undone(history).now, undone(undone(history)).now]).toEqual([2, 0]);
  expect(redone(undone(history)).now).toBe(3);
  expect(undone(begin(0)).now).toBe(0);
  const later = step(step(begin(0), 1, "depth", 0), 2, "depth", 5000);
  expect(undone(later).now).toBe(1);
  expect(redone(step(undone(history), 9, "", 0)).now).toBe(9);
});

test("a slider gives back the value that it stands at, for every key that has one", () => {
  for (const kind of ["pearl", "scene"] as const) {
    for (const one of declarations(kind)) {
      const scale = scaleOf(one);
      if (scale === null) continue;
      expect(scale.fromShare(0)).toBe(one.least);
      expect(scale.fromShare(1)).toBe(one.most);
      for (const share of [0.1, 0.5, 0.9]) {
        const value = scale.fromShare(share);
        const again = scale.fromShare(scale.toShare(value));
        expect(Math.abs(again - value), one.path).toBeLessThanOrEqual(0.006 * Math.abs(value));
      }
    }
  }
});

test("one press of an arrow key changes any value but one at its end, and the press back returns it", () => {
  for (const kind of ["pearl", "scene"] as const) {
    for (const one of declarations(kind)) {
      const scale = scaleOf(one);
      if (scale === null) continue;
      const given = [kind === "pearl" ? pearl : scene, one.default].map((from, i) =>
        i === 0 ? valueAt(from, one.path) : from,
      );
      const places = [0, 0.001, 0.03, 0.2, 0.5, 0.77, 0.999, 1].map((share) =>
        Number(scale.fromShare(share).toPrecision(3)),
      );
      for (const value of [...places, ...given]) {
        if (typeof value !== "number") continue;
        const isOut =
          value === one.least ? one.leastExcluded : value === one.most && one.mostExcluded;
        if (isOut || value < one.least! || value > one.most!) continue;
        for (const by of [1, -1] as const) {
          const end = by > 0 ? one.most! : one.least!;
          const isExcluded = by > 0 ? one.mostExcluded : one.leastExcluded;
          const next = pressed(value, by, one);
          if (value === end || (isExcluded && next === value)) continue;
          const said = `${one.path} ${value} ${by}`;
          expect((next - value) * by, said).toBeGreaterThan(0);
          if (next !== end) expect(pressed(next, by > 0 ? -1 : 1, one), said).toBe(value);
        }
      }
    }
  }
});

test("a day keeps its year, and goes through the year by number", () => {
  const day = dayOf("2024-12-15")!;
  expect(written(onDay(dayOfYear(day), day.year))).toBe("2024-12-15");
  expect(written(onDay(0, null))).toBe("01-01");
  expect(dayOfYear(dayOf("12-31")!)).toBe(364);
  expect(dayOf("15.12.")).toBeNull();
});

test("what is seen goes along with the hand, and the camera stays above the table", () => {
  expect(turned(scene, 100, 0)).toEqual({
    "camera.azimuth_deg": -35,
    "camera.elevation_deg": 25,
  });
  expect(turned(scene, 0, -1000)["camera.elevation_deg"]).toBe(0);
  expect(turned(scene, 0, 1000)["camera.elevation_deg"]).toBe(89);
  expect([around(190), around(-190), around(360)]).toEqual([-170, 170, 0]);
  expect(zoomed({ pearl, scene }, 0.5)).toEqual({ "camera.field_mm": 6 });
});

test("the dome shows a light where it is, and moves it there", () => {
  for (const [azimuth, elevation] of [
    [-75, 35],
    [120, 5],
    [0, 80],
  ] as const) {
    const found = directionOf(placeOf(azimuth, elevation));
    expect(found.azimuth).toBeCloseTo(azimuth, 9);
    expect(found.elevation).toBeCloseTo(elevation, 9);
  }
  const booth = SCENES.get("booth")!;
  const [panel] = lights(booth);
  expect(panel?.elevation).toBe(90);
  expect(moved(panel!, 90, 0)).toEqual({
    "windows.0.position_mm": [495, 0, 0],
    "windows.0.facing": null,
  });
  expect(lights(SCENES.get("aurora")!)).toEqual([]);
});

test("the trade's word stands beside its number", () => {
  const said = (key: string, value: number, name = "akoya-rg") => wordFor(key, value, name, "en");
  expect(said("shininess", 0.65)).toBe("Very good");
  expect(said("shininess", 1)).toBe("Excellent");
  expect(said("body.nacre_mm", 0.5)).toBe("thick");
  expect(said("body.nacre_mm", 0.5, "tahitian")).toBe("thin");
  expect(said("shape.length", 1)).toBeNull();
  expect(wordFor("body.nacre_mm", 0.2, "akoya-rg", "ja")).toBe("薄巻き");
});

test("a study names presets and what differs from them, and says what it cannot name", () => {
  const summer = withValue(pearl, "nacre.harvest", "2024-08-15");
  const lamps = withValue(scene, "windows", [...scene.windows, ...scene.windows]);
  const { toml, leftOut } = studyOf([
    { label: "as it is", specs: { pearl, scene } },
    { label: "summer", specs: { pearl: summer, scene } },
    { label: "two windows", specs: { pearl, scene: lamps } },
  ]);
  expect(leftOut).toEqual(["two windows"]);
  expect(toml).toContain('overrides = [ "nacre.harvest=\\"2024-08-15\\"" ]');
  expect(toml.match(/pearl = "akoya-rg"/g)).toHaveLength(2);
});

test("a decimal comma is a point, where it cannot part thousands", () => {
  const read = ["12,5", "0,123", "-1,25", "１２，５", "1,234", "1,2,3"].map(numberOf);
  expect(read).toEqual([12.5, 0.123, -1.25, 12.5, NaN, NaN]);
});

test("a PNG with texts has them whole ahead of its pixels, and all else as it was", () => {
  const png = Uint8Array.from({ length: 60 }, (_, i) => i);
  const marked = withTexts(png, [["nacreous:scene", "真珠"]]);
  const length = new DataView(marked.buffer).getUint32(33);
  const body = marked.subarray(37, 41 + length);
  expect(new TextDecoder().decode(body)).toBe("iTXtnacreous:scene\0\0\0\0\0真珠");
  expect(new DataView(marked.buffer).getUint32(41 + length)).toBe(crc32(body));
  expect([...marked.subarray(0, 33), ...marked.subarray(45 + length)]).toEqual([...png]);
});
