import { readFileSync } from "node:fs";
import { afterEach, expect, test } from "vitest";
import { declarations, fromToml, open } from "../../../src/viewer/specs/spec";
import { thinLayers } from "../../../src/viewer/specs/thinness";
import { dateOf, numberOf } from "../../../src/viewer/state/typed";
import { allowedJa } from "../../../src/viewer/words/allowed";
import { fileSays, knobSays, verdictJa } from "../../../src/viewer/words/complaints";
import { refusalSays } from "../../../src/viewer/words/refusals";
import { language } from "../../../src/viewer/words/speech";

afterEach(() => {
  language.value = "en";
});

const bytes = (text: string) => new TextEncoder().encode(text);

/** What the page says of a file. */
function said(text: string): readonly string[] {
  const found = open(bytes(text), "a.toml");
  return found.ok ? [] : found.complaints.map((one) => fileSays(one).text);
}

test("what every key allows is said in Japanese", () => {
  for (const kind of ["pearl", "scene"] as const) {
    for (const { path, allowed } of declarations(kind)) {
      expect(
        allowedJa(allowed, (key) => key),
        `${path}: ${allowed}`,
      ).not.toBeNull();
    }
  }
});

test("a knob's complaint has its label, its value and what is allowed, and no key of a file", () => {
  const late = fromToml("pearl", '[nacre]\nseeding = "2023-05-01"\nharvest = "9999-12-31"', "a");
  if (late.ok) throw new Error("it was taken");
  const [complaint] = late.complaints;
  if (complaint === undefined) throw new Error("it was taken");
  expect(knobSays(complaint).text).toMatch(
    /^Harvest is "9999-12-31"; allowed: 1 day to 20 years after Seeding, which is "[\d-]+"$/,
  );
  language.value = "ja";
  expect(knobSays(complaint).text).toMatch(
    /^「浜揚げ」：値は「9999-12-31」です。使える値：「挿核」（「[\d-]+」）の1日後から20年後まで。$/,
  );
});

test("a file's complaints are the command line's in English, and at their key in Japanese", () => {
  const bad = "depth = 3\nsheen = 2\nname = 4\n[body]\npigment = 'wite'";
  expect(said(bad)[1]).toBe("a.toml: depth is 3; allowed: 0 to 1");
  language.value = "ja";
  expect(said(bad)).toEqual([
    "a.toml: name：値は4です。必要なもの：引用符で囲んだ文字列。使える値：1〜120文字の一行。",
    "a.toml: depth：値は3です。使える値：0〜1。",
    expect.stringMatching(/^a\.toml: body\.pigment：値は"wite"です。.*"white"のことですか。$/),
    expect.stringMatching(/^a\.toml: sheen：このようなキーはありません。/),
  ]);
  expect(said("depth = = 3")[0]).toMatch(/^a\.toml: 1行目の9文字目：TOMLとして読めません/);
  expect(said("depth = 3").join()).not.toContain("allowed");
});

test("rules between keys are said in Japanese", () => {
  const broken = [
    "diameter_mm = 4\nbody.nacre_mm = 3",
    "model = 'transport'\ninterference.mixing = 0.5",
    "nacre.thickness_nm = [0.3, 0.4]",
    "nacre = { seeding = '2023-06-01' }",
    "nacre = { thickness_nm = [300], seed = 3 }",
    "texture = { low_per_mm = 5, high_per_mm = 2 }",
    "shape = { lumps = 0.2, lump_mm = 0.5 }",
    "[[lamps]]\nazimuth_deg = 3",
    "[[lamps]]\nazimuth_deg = 3\nelevation_deg = 3\nposition_mm = [1, 2, 3]",
    "[[windows]]\nwidth_mm = 3\nheight_mm = 3",
    "[[windows]]\nwidth_mm = 3\nheight_mm = 3\nazimuth_deg = 4",
    "[[rows]]\npearls = ['akoya-rg']",
    "sky.kind = 'panorama'",
    "texture.source = 'wool.png'",
  ];
  language.value = "ja";
  for (const text of broken) {
    const found = open(bytes(text), "a.toml");
    expect(found.ok, text).toBe(false);
    if (found.ok) continue;
    for (const { path, verdict = "" } of found.complaints) {
      expect(
        verdictJa(verdict, (key) => key),
        `${path} ${verdict}`,
      ).not.toMatch(/\b(?:is|allowed|wanted|which|with|than)\b|null/);
    }
  }
  expect(verdictJa(thinLayers([0.3]) ?? "", (key) => key)).toContain("µmで書いていませんか");
});

/** Reasons as the room of measures words them, with a number in each place. */
function reasons(file: string): string[] {
  const source = readFileSync(`../crates/measure/src/${file}`, "utf8");
  const plain = source.replace(/#\[cfg\(test\)\][\s\S]*/, "");
  const given =
    /(?:refused\.add\("[\w.]+", |refused\.add\(quantity, |let (?:reason|runs|ends) = (?:format!\()?|return refused\(|return Err\(|Some\(format!\(\s*|format!\(\s*)"([a-z][^"]{15,})"/g;
  return [...plain.matchAll(given)].map(([, text = ""]) =>
    text
      .replace(/\{[^}]*\}/g, "12.3")
      .replace("12.3 pixels of", "12 pixels of")
      .replace("wanted: 12.3 or more", "wanted: 12 or more"),
  );
}

test("what the measures refuse is said in Japanese, and other lines with a lead", () => {
  const all = ["measures.rs", "lamp.rs", "rings.rs"].flatMap(reasons);
  expect(all.length).toBeGreaterThan(10);
  language.value = "ja";
  for (const text of all) expect(refusalSays(text), text).toMatchObject({ lead: "", lang: "ja" });
  expect(refusalSays("broken off: something")).toEqual({
    lead: "英語の説明：",
    text: "broken off: something",
    lang: "en",
  });
  expect(refusalSays("body.nacre_mm is 9; allowed: 0.01 to 4 mm").text).toBe(
    "「巻き」：値は9です。使える値：0.01〜4 mm。",
  );
  language.value = "en";
  expect(refusalSays("the pearl is too small").text).toBe("the pearl is too small");
});

test("numbers and dates are taken from a Japanese keyboard too", () => {
  expect(["３５０", "－１．５", "ー２", "−3", "０。５", "1e3"].map(numberOf)).toEqual([
    350, -1.5, -2, -3, 0.5, 1000,
  ]);
  expect(["", "三", "1,500"].map(numberOf)).toEqual([NaN, NaN, NaN]);
  expect(["２０２４-08-15", "2024/8/5", "2024年2月29日"].map(dateOf)).toEqual([
    "2024-08-15",
    "2024-08-05",
    "2024-02-29",
  ]);
  expect(["2023-02-29", "2024-13-01", "15.12.2024", "2024"].map(dateOf)).toEqual(
    Array(4).fill(null),
  );
});
