// @vitest-environment node
/** Files that are dropped onto the page, and keys as its knobs need them. */

import { expect, test } from "vitest";

import {
  declarations,
  fromBytes,
  fromToml,
  open,
  type Read,
  recipeJson,
  PEARLS,
  type Pearl,
} from "../../src/viewer/specs/spec";

function bytes(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}

function lines<T>(result: Read<T>): readonly string[] {
  return result.ok ? [] : result.complaints.map((one) => one.text);
}

test("a file that a key names is taken only where it was dropped too", () => {
  const text = 'texture.source = "wool.png"';
  expect(lines(fromToml("pearl", text, "my.toml"))).toEqual([
    'my.toml: texture.source is "wool.png", which this page does not have; ' +
      "wanted: a file that was dropped onto it",
  ]);
  expect(fromToml("pearl", text, "my.toml", new Set(["wool.png"])).ok).toBe(true);
});

test("a row's own pearl files are refused, for the page shows one pearl", () => {
  const text = '[[rows]]\npearls = ["*", "mine.toml"]';
  expect(lines(fromToml("scene", text, "s.toml", new Set(["mine.toml"])))).toEqual([
    's.toml: rows.0.pearls.1 is "mine.toml"; allowed on this page: pearl presets and "*"',
  ]);
  const second = fromToml("scene", '[[rows]]\npearls = ["*1"]', "s.toml");
  if (!second.ok) throw new Error(lines(second)[0]);
  const specs = { pearl: PEARLS.get("paper") as Pearl, scene: second.value };
  expect(() => recipeJson(specs, 64, 1)).toThrow(
    'scene scene: a row has "*1"; allowed: "*0" to "*0"',
  );
});

test("a file's keys show whether it is a pearl or a scene", () => {
  expect(open(bytes("depth = 0.5"), "a.toml")).toMatchObject({
    ok: true,
    value: { kind: "pearl" },
  });
  expect(open(bytes("table.kind = 'none'"), "a.toml")).toMatchObject({ value: { kind: "scene" } });
  expect(lines(open(bytes("x = 1"), "a\u202e.toml"))).toEqual([
    expect.stringMatching(/^"a\\u202e.toml": the keys show neither a pearl nor a scene; wanted: /),
  ]);
});

test("a file is read to a length", () => {
  expect(lines(fromBytes("pearl", new Uint8Array(1_000_001).fill(35), "a.toml"))).toEqual([
    "a.toml: is longer than 1000000 bytes, the most that is read",
  ]);
});

test("a complaint says which key it is about", () => {
  const result = fromToml("pearl", "[nacre]\nprotein_nm = -3\nseed = true", "a.toml");
  expect(result.ok ? [] : result.complaints.map((one) => one.path)).toEqual([
    "nacre.protein_nm",
    "nacre.seed",
  ]);
});

test("a key's declaration has its range, unit, default and model", () => {
  const found = new Map(
    [...declarations("pearl"), ...declarations("scene")].map((one) => [one.path, one]),
  );
  expect(found.get("nacre.protein_nm")).toMatchObject({
    least: 0,
    most: 200,
    unit: "nm",
    default: 20,
  });
  expect(found.get("interference.threshold")).toMatchObject({
    mostExcluded: true,
    model: "illuminant",
  });
  expect(found.get("coat.seed")).toMatchObject({ isWhole: true, isOpen: true, default: null });
  expect(found.get("texture.source")?.files).toContain(".png");
  expect(found.get("lamps.0.spectrum")?.choices).toContain("D65");
  expect(found.get("body.pigment")?.choices).toContain("black-lip");
  expect(found.get("nacre.thickness_nm")?.unit).toBe("nm");
});
