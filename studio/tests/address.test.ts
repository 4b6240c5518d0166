import { describe, expect, test } from "vitest";
import { parametersOf, placesOf } from "../src/participant/address";

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

  test("tell people apart who share a browser, and leave the last to who comes without", () => {
    expect(placesOf("small", {})).toEqual(["small"]);
    const [one] = placesOf("small", { SONA: "1" });
    const [other] = placesOf("small", { SONA: "2" });
    expect(one).not.toBe(other);
    expect(placesOf("small", { SONA: "1" })).toContain("small");
  });
});
