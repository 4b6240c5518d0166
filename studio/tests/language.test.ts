import { expect, test } from "vitest";
import { fill, preferred, said } from "../src/shared/language";

test("the browser's first language that is offered is taken", () => {
  expect(preferred(["en", "ja"], ["fr-FR", "ja-JP", "en"])).toBe("ja");
  expect(preferred(["ja", "en"], ["fr"])).toBe("ja");
  expect(preferred([], [])).toBe("en");
});

test("words fall back to a language that is there", () => {
  expect(said({ ja: "真珠" }, "en")).toBe("真珠");
  expect(said({ en: "pearl", ja: "真珠" }, "ja")).toBe("真珠");
});

test("places are filled, and unknown ones stay to be seen", () => {
  expect(fill("{n} of {all}, {who}", { n: 1, all: 21 })).toBe("1 of 21, {who}");
});
