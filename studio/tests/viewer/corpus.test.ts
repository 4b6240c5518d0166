// @vitest-environment node
/** The viewer's reading and writing of specs against Python's: tests/viewer/test_specs.py starts it. */

import { readFileSync } from "node:fs";
import { env } from "node:process";

import { describe, expect, test } from "vitest";

import { AFTER, BEFORE } from "../../src/viewer/specs/checks";
import { TABLES } from "../../src/viewer/specs/declared";
import { general, repr } from "../../src/viewer/specs/number";
import { RULES } from "../../src/viewer/specs/rules";
import {
  fromBytes,
  fromFragment,
  fromToml,
  type Kind,
  PEARLS,
  read,
  type Read,
  recipeJson,
  SCENES,
  toFragment,
  toToml,
} from "../../src/viewer/specs/spec";
import { specJson } from "../../src/viewer/specs/write";

interface Case {
  readonly kind: Kind;
  readonly text: string;
  readonly json: string;
  readonly toml: string;
}

interface Corpus {
  readonly presets: readonly (Case & { readonly name: string })[];
  readonly recipes: readonly { pearl: string; scene: string; recipe: string }[];
  readonly valid: readonly { pearl: Case; scene: Case; recipe: string; link: string }[];
  readonly damaged: readonly { how: string; kind: Kind; bytes: string; lines: string[] }[];
  readonly numbers: readonly { number: number; repr: string; g: string; g3: string }[];
}

const path = env["NACREOUS_CORPUS"];
const corpus = (path ? JSON.parse(readFileSync(path, "utf8")) : {}) as Corpus;
/** As dropped onto the page: Python asks for files when it renders. */
const FILES = new Set(
  "lamp.csv a.csv shell/wool.PNG wool.jpeg studio.hdr a/../sky.EXR a.hdr".split(" "),
);

function value<T>(result: Read<T>): T {
  if (!result.ok) throw new Error(result.complaints.map((one) => one.text).join("\n"));
  return result.value;
}

function expectSame(kind: Kind, { text, json, toml }: Case): void {
  const spec = value(fromToml(kind, text, "a.toml", FILES));
  expect(specJson(kind, spec)).toBe(json);
  expect(toToml(kind, spec)).toBe(toml);
  expect(value(fromToml(kind, toml, "a.toml", FILES))).toEqual(spec);
  expect(value(read(kind, spec, "a.toml", FILES))).toEqual(spec);
}

describe.skipIf(!path)(
  "what Python makes of a file, the page makes of it",
  { timeout: 60_000 },
  () => {
    test("presets are complete", () => {
      for (const preset of corpus.presets) {
        expectSame(preset.kind, preset);
        const ready = preset.kind === "pearl" ? PEARLS : SCENES;
        expect(toToml(preset.kind, ready.get(preset.name) as never)).toBe(preset.toml);
      }
    });

    test("recipes are the same, with rows too", () => {
      for (const { pearl, scene, recipe } of corpus.recipes) {
        const specs = {
          pearl: value(fromToml("pearl", pearl, "p")),
          scene: value(fromToml("scene", scene, "s")),
        };
        expect(recipeJson(specs, 64, 4)).toBe(recipe);
      }
    });

    test("valid files are the same, and so are their recipes and what their links hold", async () => {
      for (const { pearl, scene, recipe, link } of corpus.valid) {
        expectSame("pearl", pearl);
        expectSame("scene", scene);
        const specs = {
          pearl: value(fromToml("pearl", pearl.text, "p", FILES)),
          scene: value(fromToml("scene", scene.text, "s", FILES)),
        };
        expect(recipeJson(specs, 256, 16)).toBe(recipe);
        for (const fragment of [await toFragment(specs), link]) {
          expect(value(await fromFragment(fragment, FILES))).toEqual(specs);
        }
      }
    });

    test("damaged files get the same complaints, line for line", () => {
      const wrong = corpus.damaged.flatMap(({ how, kind, bytes, lines }) => {
        const result = fromBytes(kind, Buffer.from(bytes, "base64"), `${kind}.toml`, FILES);
        const said = result.ok ? [] : result.complaints.map((one) => one.text);
        return said.join("\n") === lines.join("\n") ? [] : [{ how, bytes, said, lines }];
      });
      expect(wrong).toEqual([]);
    });

    test("numbers are written as Python writes them", () => {
      for (const { number, repr: long, g, g3 } of corpus.numbers) {
        expect([repr(number), general(number), general(number, 3)]).toEqual([long, g, g3]);
      }
    });
  },
);

test("every check and rule that Python has in code is here too", () => {
  const tables = Object.entries(TABLES);
  const ruled = tables.filter(([, { ruled }]) => ruled).map(([name]) => name);
  expect(Object.keys(RULES).sort()).toEqual(ruled.sort());
  const checks = tables.flatMap(([, { keys }]) =>
    Object.values(keys).flatMap((key) => key.checks ?? []),
  );
  const known = Object.keys({ ...BEFORE, ...AFTER });
  expect([...new Set(checks)].sort()).toEqual(known.sort());
});
