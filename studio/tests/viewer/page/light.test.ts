import { expect, test, vi } from "vitest";
import type { FromWorker, ToWorker } from "../../../src/viewer/light/messages";
import { nextPx } from "../../../src/viewer/light/first";
import { Pool } from "../../../src/viewer/light/pool";
import { stripes } from "../../../src/viewer/light/messages";

test("the stripes of all workers are every row once", () => {
  for (const [size, parts] of [
    [512, 1],
    [512, 3],
    [7, 4],
    [100, 4],
  ] as const) {
    const rows = Array.from({ length: parts }, (_, part) => stripes(size, part, parts))
      .flat()
      .flatMap(([first, end]) => Array.from({ length: end - first }, (_, i) => first + i));
    expect(rows.sort((a, b) => a - b)).toEqual(Array.from({ length: size }, (_, i) => i));
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

const WANTED = { recipe: "{}", size: 16, space: "srgb" as const, firstPx: 8, refine: true };
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
  two.says({ kind: "rows", ticket: 1, first: 8, size: 16, made: half(2), covered: covers(8) });
  expect(refined).not.toHaveBeenCalled();
  one.says({ kind: "rows", ticket: 1, first: 0, size: 16, made: half(1), covered: covers(8) });
  expect(refined).toHaveBeenCalledTimes(1);
  const codes = refined.mock.calls[0]?.[0] as Uint8ClampedArray;
  expect([codes[0], codes.at(-1)]).toEqual([1, 2]);
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
  one.says({ kind: "rows", ticket: 1, first: 0, size: 16, made: codes, covered: covers(16) });
  expect(refined).not.toHaveBeenCalled();
  one.says({ kind: "rows", ticket: 2, first: 0, size: 16, made: codes, covered: covers(16) });
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
  one.says({ kind: "rows", ticket: 1, first: 0, size: 16, made: pixels, covered: covers(16) });
  expect(one.told.at(-1)).toMatchObject({ kind: "look", ticket: 1 });
  const codes = new Uint8ClampedArray(16 * 16 * 4);
  one.says({ kind: "whole", ticket: 1, codes });
  expect(refined).toHaveBeenCalledWith(codes, 16, covers(16));
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
  expect(nextPx({ widthPx: 256, tookMs: 8 })).toBe(512);
  expect(nextPx({ widthPx: 256, tookMs: 25 })).toBe(256);
  expect(nextPx({ widthPx: 512, tookMs: 30 })).toBe(512);
  expect(nextPx({ widthPx: 512, tookMs: 80 })).toBe(256);
});
