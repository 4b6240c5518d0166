import { expect, test, vi } from "vitest";
import { Bands } from "../../../src/viewer/light/bands";
import type { FromWorker, ToWorker } from "../../../src/viewer/light/messages";
import { FirstSize } from "../../../src/viewer/light/first";
import { Pool, Round, agreed, inTurn, type Whole } from "../../../src/viewer/light/pool";

test("every row is handed out once, and then none", () => {
  for (const size of [7, 16, 100]) {
    const bands = new Bands(size, 2);
    let next = 0;
    while (next < size) {
      const [first, end] = bands.take();
      expect(first).toBe(next);
      expect(end).toBeGreaterThan(first);
      next = end;
    }
    expect(next).toBe(size);
    expect(bands.take()).toEqual([size, size]);
  }
});

class FakeWorker {
  static all: FakeWorker[] = [];
  told: ToWorker[] = [];
  onmessage: ((event: { data: FromWorker }) => void) | null = null;
  constructor() {
    FakeWorker.all.push(this);
  }
  postMessage(message: ToWorker): void {
    this.told.push(message);
  }
  says(data: FromWorker): void {
    this.onmessage?.({ data });
  }
  terminate(): void {}
}

async function pool(count: number) {
  FakeWorker.all = [];
  vi.stubGlobal("Worker", FakeWorker);
  const made = new Pool(count, Promise.resolve({} as WebAssembly.Module));
  await new Promise((go) => setTimeout(go));
  return { made, workers: FakeWorker.all };
}

const WANTED = { recipe: "{}", size: 16, space: "srgb" as const, firstPx: 8, restMs: 0 };
const light = new Float32Array(16 * 16 * 3);
const covers = (rows: number) => new Uint8Array(rows * 16).fill(1);
const settled = () => new Promise((go) => setTimeout(go));

test("rows of two workers become one picture, told once", async () => {
  const { made, workers } = await pool(2);
  const refined = vi.fn();
  made.show({ ...WANTED, refined, failed: vi.fn() });
  await settled();
  const [one, two] = workers as [FakeWorker, FakeWorker];
  expect(one.told.at(-1)).toMatchObject({ kind: "show", ticket: 1, part: 0, firstPx: 8 });
  expect(two.told.at(-1)).toMatchObject({ kind: "show", ticket: 1, part: 1, firstPx: 0 });
  const half = (code: number) => new Uint8ClampedArray(8 * 16 * 4).fill(code);
  const third = (value: number) => new Float32Array(8 * 16 * 3).fill(value);
  const rows = { kind: "rows" as const, ticket: 1, size: 16, covered: covers(8) };
  two.says({ ...rows, first: 8, made: half(2), light: third(2) });
  expect(refined).not.toHaveBeenCalled();
  one.says({ ...rows, first: 0, made: half(1), light: third(1) });
  expect(refined).toHaveBeenCalledTimes(1);
  const { codes, light } = refined.mock.calls[0]?.[0] as Whole;
  expect([codes[0], codes.at(-1), light[0], light.at(-1)]).toEqual([1, 2, 1, 2]);
});

test("a worker that is free gets the next rows of what is wanted now", async () => {
  const { made, workers } = await pool(2);
  made.show({ ...WANTED, failed: vi.fn() });
  await settled();
  const [one, two] = workers as [FakeWorker, FakeWorker];
  two.says({ kind: "free", ticket: 1, part: 1 });
  two.says({ kind: "free", ticket: 1, part: 1 });
  one.says({ kind: "free", ticket: 1, part: 0 });
  const ends = [one, two].map((worker) => worker.told.at(-1)) as { first: number; end: number }[];
  expect(ends[0]?.first).toBe(ends[1]?.end);
  made.show({ ...WANTED, failed: vi.fn() });
  await settled();
  one.says({ kind: "free", ticket: 1, part: 0 }); // out of date
  expect(one.told.at(-1)).toMatchObject({ kind: "show", ticket: 2 });
  one.says({ kind: "free", ticket: 2, part: 0 });
  expect(one.told.at(-1)).toMatchObject({ kind: "band", ticket: 2, first: 0 });
});

test("rows out of date are dropped; a first picture is shown though the hand went on", async () => {
  const { made, workers } = await pool(1);
  const [first, refined] = [vi.fn(), vi.fn()];
  made.show({ ...WANTED, first, refined, failed: vi.fn() });
  made.show({ ...WANTED, first, refined, failed: vi.fn() });
  await settled();
  const [one] = workers as [FakeWorker];
  expect(one.told.filter((message) => message.kind === "show")).toHaveLength(1);
  const codes = new Uint8ClampedArray(16 * 16 * 4);
  one.says({ kind: "first", ticket: 1, codes, widthPx: 8, tookMs: 5 });
  expect(first).toHaveBeenLastCalledWith(expect.objectContaining({ codes }), false);
  const rows = { kind: "rows" as const, first: 0, size: 16, made: codes, covered: covers(16) };
  one.says({ ...rows, ticket: 1, light });
  expect(refined).not.toHaveBeenCalled();
  one.says({ ...rows, ticket: 2, light });
  expect(refined).toHaveBeenCalledTimes(1);
  one.says({ kind: "first", ticket: 1, codes, widthPx: 8, tookMs: 5 });
  expect(first).toHaveBeenCalledTimes(1); // the whole picture is there
});

test("pixels with glare are joined first and looked at as one", async () => {
  const { made, workers } = await pool(1);
  const refined = vi.fn();
  made.show({ ...WANTED, refined, failed: vi.fn() });
  await settled();
  const [one] = workers as [FakeWorker];
  const pixels = new Float32Array(16 * 16 * 17);
  one.says({
    kind: "rows",
    ticket: 1,
    first: 0,
    size: 16,
    made: pixels,
    covered: covers(16),
    light: null,
  });
  expect(one.told.at(-1)).toMatchObject({ kind: "look", ticket: 1 });
  const codes = new Uint8ClampedArray(16 * 16 * 4);
  one.says({ kind: "whole", ticket: 1, codes, light });
  expect(refined).toHaveBeenCalledWith({ codes, size: 16, light, covered: covers(16) });
});

test("dropped files go to the workers once, and again when they are others", async () => {
  const { made, workers } = await pool(1);
  const [one] = workers as [FakeWorker];
  const shown = async (resources: object) => {
    made.show({ ...WANTED, resources, failed: vi.fn() });
    await settled();
    return one.told.at(-1);
  };
  const [sky, other] = [{ panoramas: [] }, { panoramas: [] }];
  expect(await shown(sky)).toHaveProperty("resources", sky);
  expect(await shown(sky)).not.toHaveProperty("resources");
  expect((await shown(other)) as object).toHaveProperty("resources");
});

test("first pictures are large where they keep up with the hand, and small where not", () => {
  const sizes = new FirstSize();
  expect(sizes.next(false)).toBe(512);
  expect(sizes.next(true)).toBe(256); // the camera turns
  sizes.learn({ widthPx: 256, tookMs: 300 });
  expect(sizes.next(false)).toBe(512);
  for (const tookMs of [300, 200, 150]) sizes.learn({ widthPx: 512, tookMs });
  const next = Array.from({ length: 10 }, () => sizes.next(false));
  expect(next.filter((px) => px === 512)).toHaveLength(1); // whether the machine is free again
  sizes.learn({ widthPx: 512, tookMs: 30 });
  expect(sizes.next(false)).toBe(512);
});

test("what all tell in a round is there with the last of them, in their order", () => {
  const shares = new Round<string>(3);
  expect(shares.take(0, 2, "c")).toBeNull();
  expect(shares.take(1, 0, "ahead")).toBeNull();
  expect(shares.take(0, 0, "a")).toBeNull();
  expect(shares.take(0, 1, "b")).toEqual(["a", "b", "c"]);
});

test("workers that know different things work on what the first of them lacks", async () => {
  expect(agreed([null, "reflections", "films"])).toBe("films");
  expect(agreed([null, "reflections"])).toBe("reflections");
  expect(agreed([null, null])).toBeNull();
  const { made, workers } = await pool(2);
  made.show({ ...WANTED, failed: vi.fn() });
  await settled();
  const [one, two] = workers as [FakeWorker, FakeWorker];
  one.says({ kind: "lacks", ticket: 1, round: 0, part: 0, shared: null });
  expect(one.told.at(-1)).toMatchObject({ kind: "show" });
  two.says({ kind: "lacks", ticket: 1, round: 0, part: 1, shared: "films" });
  for (const worker of [one, two]) {
    expect(worker.told.at(-1)).toEqual({ kind: "agreed", ticket: 1, round: 0, shared: "films" });
  }
});

test("pieces of workers come back in the order of their numbers", () => {
  expect(
    inTurn([
      [0, 3, 6],
      [1, 4],
      [2, 5],
    ]),
  ).toEqual([0, 1, 2, 3, 4, 5, 6]);
  expect(inTurn([[0], [1], [], []])).toEqual([0, 1]);
});
