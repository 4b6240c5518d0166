import { expect, test } from "vitest";
import type { Trial } from "../src/participant/api";
import { blocksOf, placeOf } from "../src/participant/block";
import { barred } from "../src/participant/entering";
import { linked } from "../src/participant/storage/kept";
import { claim } from "../src/participant/storage/tabs";
import type { Study } from "../src/participant/api";

const trials: Trial[] = [0, 1, 2, 3, 4, 5].map((trial) => ({
  trial,
  question: "deeper",
  left: "a",
  right: "b",
  training: trial < 2,
  break_before: trial === 4,
}));
const numbers = (blocks: Trial[][]) => blocks.map((block) => block.map(({ trial }) => trial));

test("blocks end with the training and at breaks", () => {
  expect(numbers(blocksOf(trials, 0))).toEqual([
    [0, 1],
    [2, 3],
    [4, 5],
  ]);
});

test("a sitting that goes on begins with the rest of a block", () => {
  expect(numbers(blocksOf(trials, 3))).toEqual([[3], [4, 5]]);
  expect(blocksOf(trials, 6)).toEqual([]);
});

test("training and what counts are told apart in the progress", () => {
  expect(trials.map((trial) => placeOf(trials, trial))).toEqual([
    { n: 1, all: 2 },
    { n: 2, all: 2 },
    { n: 1, all: 4 },
    { n: 2, all: 4 },
    { n: 3, all: 4 },
    { n: 4, all: 4 },
  ]);
});

test("who may not enter is told why", () => {
  const study = { state: "open", registration: "invited" } as Study;
  expect(barred(study, true)).toBeNull();
  expect(barred(study, false)).toBe("invited");
  expect(barred({ ...study, registration: "open" }, false)).toBeNull();
  expect(barred({ ...study, state: "paused" }, true)).toBe("paused");
});

test("a link carries its token behind the #", () => {
  expect(linked("#AbCdEf0123456789_-AbCd")).toBe("AbCdEf0123456789_-AbCd");
  expect(linked("")).toBeNull();
  expect(linked("#top")).toBeNull();
  expect(linked("#<script>alert(1)</script>")).toBeNull();
});

test("of two tabs the first one goes on, and one of two at once", async () => {
  expect(await claim("first come")).toBe(true);
  expect(await claim("first come")).toBe(false);
  const both = await Promise.all([claim("at once"), claim("at once")]);
  expect(both.filter(Boolean).length).toBe(1);
});
