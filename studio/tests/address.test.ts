import { describe, expect, test } from "vitest";
import { canBeKept, parametersOf, placesOf } from "../src/participant/address";

describe("the parameters of an address", () => {
  test("are those that the study declares, decoded, the first of each", () => {
    const search =
      "?PROLIFIC_PID=5f%200c&utm_source=mail&PROLIFIC_PID=other&STUDY_ID=&simulate=visual";
    const found = parametersOf(search, ["PROLIFIC_PID", "STUDY_ID", "SESSION_ID"]);
    expect(found).toEqual({ PROLIFIC_PID: "5f 0c" });
  });

  test("are none where none are declared", () => {
    expect(parametersOf("?PROLIFIC_PID=5f0c", [])).toEqual({});
  });

  test("are refused where the server would refuse them: too long, hidden or control characters", () => {
    for (const good of ["7".repeat(200), "😀".repeat(200), "آن\u200cها", "5f 0c", "真珠　"]) {
      expect(canBeKept({ SONA: good })).toBe(true);
    }
    for (const letter of ["\0", "\n", "\t", "\x1b", "\x7f", "\x85", "\u202e", "\u2028", "\ue000"]) {
      expect(canBeKept({ PROLIFIC_PID: "5f", SONA: `5f${letter}0c` })).toBe(false);
    }
    expect(canBeKept({ SONA: "7".repeat(201) })).toBe(false);
    expect(canBeKept({})).toBe(true);
  });

  test("tell people apart who share a browser, and leave the last to who comes without", () => {
    expect(placesOf("small", {})).toEqual(["small"]);
    const [one] = placesOf("small", { SONA: "1" });
    const [other] = placesOf("small", { SONA: "2" });
    expect(one).not.toBe(other);
    expect(placesOf("small", { SONA: "1" })).toContain("small");
  });
});
