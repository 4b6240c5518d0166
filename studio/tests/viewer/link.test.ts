// @vitest-environment node
/** Specs in the fragment of an address. */

import { deflateSync } from "node:zlib";

import { expect, test } from "vitest";

import {
  fromFragment,
  fromToml,
  PEARLS,
  read,
  type Pearl,
  type Scene,
  SCENES,
  toFragment,
} from "../../src/viewer/specs/spec";

const pearl = PEARLS.get("akoya-rg") as Pearl;
const scene = SCENES.get("booth") as Scene;

function link(text: string): string {
  return `1.${deflateSync(text).toString("base64url")}`;
}

async function complaint(fragment: string): Promise<string> {
  const result = await fromFragment(fragment);
  if (result.ok) throw new Error("it was taken");
  expect(result.complaints).toHaveLength(1);
  return result.complaints[0]?.text ?? "";
}

test("a link of presets is short, and holds them", async () => {
  const fragment = await toFragment({ pearl, scene });
  expect(fragment).toMatch(/^1\.[A-Za-z0-9_-]{10,60}$/);
  expect(await fromFragment(`#${fragment}`)).toEqual({ ok: true, value: { pearl, scene } });
});

test("a link holds seeds beyond 2^53, listed layers and the other model", async () => {
  const other = read("pearl", { model: "illuminant", nacre: { thickness_nm: [400, 410.5] } }, "p");
  const seeded = fromToml("pearl", "nacre.seed = 9223372036854775807", "p");
  for (const made of [other, seeded]) {
    if (!made.ok) throw new Error(made.complaints[0]?.text);
    const specs = { pearl: made.value, scene };
    expect(await fromFragment(await toFragment(specs))).toEqual({ ok: true, value: specs });
  }
});

test("a damaged link gets one complaint, or means the very same", { timeout: 60_000 }, async () => {
  const specs = { pearl: { ...pearl, depth: 0.123 }, scene };
  const fragment = await toFragment(specs);
  let taken = 0;
  for (let at = 0; at < fragment.length; at += 1) {
    const changed = fragment[at] === "A" ? "B" : "A";
    for (const put of ["", changed, "%"]) {
      const damaged = fragment.slice(0, at) + put + fragment.slice(at + 1);
      const result = await fromFragment(damaged);
      if (result.ok) {
        taken += 1; // the last letter has bits that say nothing
        expect(result.value).toEqual(specs);
      } else {
        expect(await complaint(damaged)).toMatch(/^The link cannot be used: .*; wanted: /);
      }
    }
  }
  expect(taken).toBeLessThan(3);
});

test.each([
  ["", "begin with"],
  ["2.AAAA", "newer"],
  [`1.${"A".repeat(400_001)}`, "longer"],
  [link(" ".repeat(2_000_000)), "more than 1000000 bytes"],
  [link("[".repeat(500_000) + "]".repeat(500_000)), "no pearl and scene"],
  [
    link(`["paper", {"name": ${"[".repeat(400_000) + "]".repeat(400_000)}}, "booth", {}]`),
    "name is",
  ],
  [link("7"), "no pearl and scene"],
  [link('["none", {}, "booth", {}]'), "preset that is not here"],
  [link('["__proto__", {}, "booth", {}]'), "preset that is not here"],
  [link('["paper", 7, "booth", {}]'), "the link's pearl: is 7; wanted: a table of keys"],
  [link('["paper", {"depth": 7}, "booth", {}]'), "the link's pearl: depth is 7; allowed: 0 to 1"],
  [link('["paper", {"__proto__": 1}, "booth", {"x": 1}]'), "__proto__ is not a key here"],
  [link('["paper", {}, "booth", {"lamps": [{"spectrum": "a.csv", "x": 1}]}]'), "(and more)"],
  [link('["paper", {}, "booth", {"sky": {"kind": "panorama", "path": "a.hdr"}}]'), "dropped onto"],
])("%#: one complaint of a link that holds something else", async (fragment, words) => {
  expect(await complaint(fragment)).toContain(words);
});
