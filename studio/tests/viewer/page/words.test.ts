import { expect, test } from "vitest";
import { declarations } from "../../../src/viewer/specs/spec";
import {
  ESSENTIALS,
  LAMP_KEYS,
  PEARL_GROUPS,
  ROW_KEYS,
  SCENE_GROUPS,
  WINDOW_KEYS,
} from "../../../src/viewer/state/groups";
import { declared } from "../../../src/viewer/state/path";
import { CHOICES } from "../../../src/viewer/words/choices";
import { KEYS as EN } from "../../../src/viewer/words/keys.en";
import { KEYS as JA } from "../../../src/viewer/words/keys.ja";

/** Lists are no keys to turn; their tables' keys are. */
const keys = (kind: "pearl" | "scene") =>
  [...new Set(declarations(kind).map((one) => declared(one.path)))].filter(
    (key) => !["lamps", "windows", "rows"].includes(key),
  );

/** Indices are turned where their medium is. */
const alone = (kind: "pearl" | "scene") => keys(kind).filter((key) => !/[.]n_[oe]$/.test(key));

test("every key has a name and a sentence in both languages, and none has one too many", () => {
  const all = [...keys("pearl"), ...keys("scene")];
  for (const words of [EN, JA]) {
    expect(Object.keys(words).sort()).toEqual([...new Set(all)].sort());
    for (const [name, says] of Object.values(words)) {
      expect(name).not.toBe("");
      expect(says).toMatch(/[.。]$/);
    }
  }
});

test("every key stands in exactly one group", () => {
  const grouped = (groups: typeof PEARL_GROUPS) =>
    groups.flatMap((group) => [...group.knobs, ...group.physics]);
  expect([...ESSENTIALS, ...grouped(PEARL_GROUPS)].sort()).toEqual(alone("pearl").sort());
  const scene = [...grouped(SCENE_GROUPS), ...LAMP_KEYS, ...WINDOW_KEYS, ...ROW_KEYS];
  expect(scene.sort()).toEqual(alone("scene").sort());
});

test("every choice of a key has a name", () => {
  const choices = ["pearl", "scene"].flatMap((kind) =>
    declarations(kind as "pearl" | "scene")
      .filter((one) => !/preset$|pearls$|spectrum$|white$/.test(one.path))
      .flatMap((one) => one.choices ?? []),
  );
  expect(choices.filter((choice) => CHOICES[choice] === undefined)).toEqual([]);
});
