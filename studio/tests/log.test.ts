import "fake-indexeddb/auto";
import { IDBFactory } from "fake-indexeddb";
import { beforeEach, expect, test } from "vitest";
import { openDatabase } from "../src/participant/storage/database";
import { Kept } from "../src/participant/storage/kept";
import { LastingLog, PassingLog } from "../src/participant/storage/log";
import { resume } from "../src/participant/storage/resume";
import { answer } from "./answer";

beforeEach(() => {
  globalThis.indexedDB = new IDBFactory();
});

test("answers come back in the order of their trials, from a new page too", async () => {
  const log = new LastingLog(await openDatabase(), "a sitting");
  for (const trial of [0, 1, 2, 10]) await log.add(answer(trial));
  const again = new LastingLog(await openDatabase(), "a sitting");
  expect((await again.all()).map(({ trial }) => trial)).toEqual([0, 1, 2, 10]);
  expect((await again.all())[0]).toEqual(answer(0));
});

test("the first answer to a trial stays", async () => {
  const database = await openDatabase();
  for (const log of [new LastingLog(database, "a sitting"), new PassingLog()]) {
    await log.add(answer(0, "left"));
    await log.add(answer(0, "right"));
    expect((await log.all()).map(({ chosen }) => chosen)).toEqual(["left"]);
  }
});

test("sittings do not see each other's answers", async () => {
  const database = await openDatabase();
  await new LastingLog(database, "one").add(answer(0));
  expect(await new LastingLog(database, "on").all()).toEqual([]);
  expect(await new LastingLog(database, "one more").all()).toEqual([]);
});

test("a log that cannot be written says so", async () => {
  const database = await openDatabase();
  const log = new LastingLog(database, "a sitting");
  database.close();
  await expect(log.add(answer(0))).rejects.toThrow();
});

test("a browser that keeps nothing is no obstacle, and the address holds the token", async () => {
  globalThis.indexedDB = {
    open: () => {
      throw new DOMException("no", "SecurityError");
    },
  } as unknown as IDBFactory;
  const kept = await Kept.open();
  await kept.keepToken(["a study"], "token-of-22-characters");
  expect(location.hash).toBe("#token-of-22-characters");
  expect(await kept.token("a study")).toBeNull();
  expect(kept.log("a sitting").lasting).toBe(false);
  await kept.forgetToken(["a study"]);
  expect(location.hash).toBe("");
});

test("a token is kept by study and leaves the address", async () => {
  location.hash = "#token-of-22-characters";
  const kept = await Kept.open();
  await kept.keepToken(["a study"], "token-of-22-characters");
  expect(location.hash).toBe("");
  expect(await (await Kept.open()).token("a study")).toBe("token-of-22-characters");
  expect(await kept.token("another")).toBeNull();
});

test("a sitting is unfinished from its screen check to its end", async () => {
  const kept = await Kept.open();
  await kept.keepScreen("one", {} as never);
  await kept.keepScreen("other", {} as never);
  await kept.finish("one");
  expect(await kept.unfinished()).toEqual(["other"]);
});

test("a sitting goes on after the last answer that anybody has", () => {
  const kept = [0, 1, 2, 3].map((trial) => answer(trial));
  expect(resume(0, [])).toEqual({ next: 0, unsent: [] });
  expect(resume(2, kept)).toEqual({ next: 4, unsent: kept.slice(2) });
  expect(resume(4, kept)).toEqual({ next: 4, unsent: [] });
  expect(resume(7, kept)).toEqual({ next: 7, unsent: [] }); // answered in another browser
});

test("what lies behind a gap waits for the trials before it", () => {
  expect(resume(0, [answer(1), answer(2)])).toEqual({ next: 0, unsent: [] });
  expect(resume(1, [answer(1), answer(3)])).toEqual({ next: 2, unsent: [answer(1)] });
});
