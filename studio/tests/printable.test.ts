import { expect, test } from "vitest";
import { printable } from "../src/shared/printable";

test("control and invisible characters are shown by their numbers", () => {
  expect(printable("a\u001b[31m\u202eb\u0085\r")).toBe("a\\u001b[31m\\u202eb\\u0085\\u000d");
});

test("words, lines, joiners and emoji stay", () => {
  const text = "真珠 café\nمی\u200cخواهم 👩\u200d👧 🏴\u{e0067}\u{e007f}";
  expect(printable(text)).toBe(text);
});
