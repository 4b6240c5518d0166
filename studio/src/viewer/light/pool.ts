/** Workers that share a picture by bands of rows. */

import type { PearlJson, RecipeJson, Resources, Shared, Space } from "nacreous-wasm";
import { Bands } from "./bands";
import type { First } from "./first";
import type { Codes, FromWorker, Light, Show, ToWorker } from "./messages";

/** A whole picture. */
export interface Whole {
  readonly codes: Codes;
  readonly size: number;
  /** Linear, three numbers a pixel. */
  readonly light: Light;
  /** 1 of each pixel that is a pearl's. */
  readonly covered: Uint8Array<ArrayBuffer>;
}

/** A picture, and what is to be done with it; whatever is out of date is never told. */
export interface Wanted {
  readonly recipe: RecipeJson;
  readonly resources?: Resources;
  readonly size: number;
  readonly space: Space;
  /** Pixels a side of the first picture; 0 for none. */
  readonly firstPx: number;
  /** How long a hand must rest before the picture is refined, in ms; null where it is not. */
  readonly restMs: number | null;
  /** isCurrent: false of a picture that was asked for just before, while things move. */
  first?(made: First, isCurrent: boolean): void;
  progress?(share: number): void;
  refined?(whole: Whole): void;
  failed(text: string): void;
}

/** What all workers tell in a round, until all have. */
export class Round<T> {
  private readonly rounds = new Map<number, Map<number, T>>();

  constructor(private readonly workers: number) {}

  /** All of the round in the workers' order, with the last of them; else null. */
  take(round: number, part: number, told: T): T[] | null {
    const there = this.rounds.get(round) ?? new Map<number, T>();
    this.rounds.set(round, there.set(part, told));
    if (there.size < this.workers) return null;
    this.rounds.delete(round);
    return [...there].sort(([a], [b]) => a - b).map(([, one]) => one);
  }
}

/** The first that any worker lacks. */
export function agreed(lacked: readonly (Shared | null)[]): Shared | null {
  const inOrder: readonly Shared[] = ["films", "reflections"];
  return inOrder.find((one) => lacked.includes(one)) ?? null;
}

/** The first of each, the second of each, and so on. */
export function inTurn<T>(all: readonly (readonly T[])[]): T[] {
  const longest = Math.max(...all.map((own) => own.length));
  return Array.from({ length: longest }, (_, at) =>
    all.flatMap((own) => own.slice(at, at + 1)),
  ).flat();
}

/** Rows are told of so many ms after those before: each time draws the page anew, which takes 12 ms of a processor in headless
 * Chromium, and where processors are few the workers wait for that. */
const TOLD_MS = 150;

/** How many workers a picture gets on a machine with so many processors. */
export function workersFor(processors: number): number {
  return Math.max(1, Math.min(4, Number.isFinite(processors) ? Math.floor(processors) : 1));
}

export class Pool {
  private readonly workers: Worker[] = [];
  private readonly ready: Promise<void>;
  private ticket = 0;
  /** The ticket of the last picture that was finished. */
  private whole = 0;
  private wanted: Wanted | null = null;
  private codes: Codes | null = null;
  private light: Light | null = null;
  private pixels: Float32Array<ArrayBuffer> | null = null;
  private covered: Uint8Array<ArrayBuffer> | null = null;
  /** What the workers were last told of dropped files. */
  private told: Resources | undefined;
  private rowsThere = 0;
  private toldAt = 0;
  private bands = new Bands(0, 1);
  private lacks = new Round<Shared | null>(0);
  private shares = new Round<readonly Float64Array[]>(0);
  private question = 0;
  private readonly questions = new Map<number, (keys: Readonly<Record<string, number>>) => void>();

  constructor(count: number, program: Promise<WebAssembly.Module>) {
    for (let part = 0; part < count; part += 1) {
      const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
      worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.take(data);
      worker.onerror = (event) => this.wanted?.failed(event.message || "a worker could not start");
      this.workers.push(worker);
    }
    this.ready = program.then((module) => {
      for (const part of this.workers.keys()) this.tell(part, { kind: "load", module });
    });
    this.ready.catch((error: unknown) => this.wanted?.failed(String(error)));
  }

  /** Makes this picture, and drops whichever was being made. */
  show(wanted: Wanted): void {
    this.ticket += 1;
    this.wanted = wanted;
    this.codes = this.light = this.pixels = this.covered = null;
    this.rowsThere = 0;
    this.bands = new Bands(wanted.size, this.workers.length);
    this.lacks = new Round(this.workers.length);
    this.shares = new Round(this.workers.length);
    const { recipe, resources, space, restMs } = wanted;
    const { ticket } = this;
    this.whenReady(ticket, () => {
      const isNew = resources !== undefined && resources !== this.told;
      if (isNew) this.told = resources;
      for (const part of this.workers.keys()) {
        const show: Show = {
          kind: "show",
          ticket,
          recipe,
          ...(isNew ? { resources } : {}),
          space,
          firstPx: part === 0 ? wanted.firstPx : 0,
          restMs,
          part,
          parts: this.workers.length,
        };
        this.tell(part, show);
      }
    });
  }

  /** What a pearl's open keys come to. */
  resolve(pearl: PearlJson): Promise<Readonly<Record<string, number>>> {
    this.question += 1;
    const { question } = this;
    return new Promise((done) => {
      this.questions.set(question, done);
      void this.ready.then(() => this.tell(0, { kind: "resolve", question, pearl }));
    });
  }

  close(): void {
    for (const worker of this.workers) worker.terminate();
    this.wanted = null;
  }

  private whenReady(ticket: number, then: () => void): void {
    const go = () => {
      if (ticket === this.ticket) then();
    };
    this.ready.then(go, (error: unknown) => this.wanted?.failed(String(error)));
  }

  private tell(part: number, message: ToWorker, transfer: Transferable[] = []): void {
    this.workers[part]?.postMessage(message, transfer);
  }

  private take(told: FromWorker): void {
    if (told.kind === "resolved") {
      this.questions.get(told.question)?.(told.keys);
      this.questions.delete(told.question);
      return;
    }
    const { wanted } = this;
    if (wanted === null) return;
    const isCurrent = told.ticket === this.ticket;
    if (told.kind === "first" && told.ticket > this.whole) {
      wanted.first?.(told, isCurrent);
    }
    if (!isCurrent || told.kind === "first") return;
    if (told.kind === "failed") wanted.failed(told.text);
    else if (told.kind === "lacks") this.agree(told);
    else if (told.kind === "part") this.handRound(told);
    else if (told.kind === "free") this.handBand(told.ticket, told.part);
    else if (told.kind === "whole") this.finish(wanted, told.codes, told.light);
    else this.join(wanted, told);
  }

  /** Once all workers have told what they lack, each hears what all work on. */
  private agree({ ticket, round, part, shared }: Extract<FromWorker, { kind: "lacks" }>): void {
    const lacked = this.lacks.take(round, part, shared);
    if (lacked === null) return;
    for (const worker of this.workers.keys()) {
      this.tell(worker, { kind: "agreed", ticket, round, shared: agreed(lacked) });
    }
  }

  /** Once all workers have told their pieces of what is shared out, each gets all of them. */
  private handRound(told: Extract<FromWorker, { kind: "part" }>): void {
    const { ticket, round } = told;
    const all = this.shares.take(round, told.part, told.pieces);
    if (all === null) return;
    const pieces = inTurn(all);
    for (const worker of this.workers.keys()) {
      this.tell(worker, { kind: "parts", ticket, round, pieces });
    }
  }

  private handBand(ticket: number, part: number): void {
    const [first, end] = this.bands.take();
    this.tell(part, { kind: "band", ticket, first, end });
  }

  /** Puts rows in their place; with the last of them the picture is whole. */
  private join(wanted: Wanted, told: Extract<FromWorker, { kind: "rows" }>): void {
    const { first, size, made } = told;
    const glares = made instanceof Float32Array;
    const channels = glares ? 17 : 4;
    if (made instanceof Float32Array) {
      this.pixels ??= new Float32Array(size * size * channels);
      this.pixels.set(made, first * size * channels);
    } else {
      this.codes ??= new Uint8ClampedArray(size * size * channels);
      this.codes.set(made, first * size * channels);
      this.light ??= new Float32Array(size * size * 3);
      if (told.light !== null) this.light.set(told.light, first * size * 3);
    }
    this.covered ??= new Uint8Array(size * size);
    this.covered.set(told.covered, first * size);
    this.rowsThere += made.length / (size * channels);
    if (performance.now() - this.toldAt > TOLD_MS) {
      this.toldAt = performance.now();
      wanted.progress?.(this.rowsThere / size);
    }
    if (this.rowsThere < size) return;
    if (this.pixels !== null) {
      const { ticket, pixels } = this;
      this.tell(0, { kind: "look", ticket, pixels, space: wanted.space }, [pixels.buffer]);
      this.pixels = null;
    } else if (this.codes !== null && this.light !== null) {
      this.finish(wanted, this.codes, this.light);
    }
  }

  private finish(wanted: Wanted, codes: Codes, light: Light): void {
    this.whole = this.ticket;
    const covered = this.covered ?? new Uint8Array(codes.length / 4);
    wanted.refined?.({ codes, size: wanted.size, light, covered });
  }
}
