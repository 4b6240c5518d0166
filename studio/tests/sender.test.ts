import { expect, test } from "vitest";
import { Problem } from "../src/shared/http";
import type { Answer } from "../src/participant/api";
import { backoff_ms, Sender } from "../src/participant/storage/sender";
import { answer } from "./answer";

/** A server that takes answers in order, and fails as told before each. */
class Server {
  taken: Answer[] = [];
  attempts: number[] = [];
  waits_ms: number[] = [];
  connected: boolean[] = [];
  refusal: Problem | null = null;
  log: Answer[] = [];

  constructor(private readonly failures: (Problem | "lost receipt")[] = []) {}

  /** `first`: called when the first answer has been put. */
  sender(first: () => Promise<void> = async () => undefined): Sender {
    return new Sender({
      put: async (given) => {
        await this.put(given);
        if (given.trial === 0) void first();
      },
      missing: async () => this.log.filter(({ trial }) => trial >= this.taken.length),
      connected: (yes) => this.connected.push(yes),
      refused: (problem) => (this.refusal = problem),
      pause: async (wait_ms) => void this.waits_ms.push(wait_ms),
    });
  }

  private async put(given: Answer): Promise<void> {
    this.attempts.push(given.trial);
    const failure = this.failures.shift();
    if (failure instanceof Problem) throw failure;
    const there = this.taken[given.trial];
    if (there === undefined && given.trial !== this.taken.length) {
      throw new Problem("before its turn", "turn", 409);
    }
    if (there !== undefined && there.chosen !== given.chosen) {
      throw new Problem("answered otherwise", "conflict", 409);
    }
    this.taken[given.trial] ??= given;
    if (failure === "lost receipt") throw new Problem("cut off", "network", 0);
  }
}

const network = new Problem("no network", "network", 0);
const broken = new Problem("broken", "unknown", 500);
const full = new Problem("disk full", "store", 503, 2000);

test("answers arrive in order, once, however often the way fails", async () => {
  const server = new Server([network, "lost receipt", broken, full, network]);
  const sender = server.sender();
  for (let trial = 0; trial < 5; trial += 1) sender.add(answer(trial));
  await sender.settled();
  expect(server.taken.map(({ trial }) => trial)).toEqual([0, 1, 2, 3, 4]);
  expect(server.attempts).toEqual([0, 0, 0, 0, 0, 0, 1, 2, 3, 4]);
  expect(sender.waiting).toBe(0);
  expect(server.connected).toEqual([
    false,
    false,
    false,
    false,
    false,
    true,
    true,
    true,
    true,
    true,
  ]);
});

test("waits grow to eight seconds, and are as long as the server asks for", async () => {
  expect([1, 2, 3, 4, 5, 6, 60].map((failures) => backoff_ms(failures, 0.5))).toEqual([
    500, 1000, 2000, 4000, 8000, 8000, 8000,
  ]);
  const server = new Server([full]);
  const sender = server.sender();
  sender.add(answer(0));
  await sender.settled();
  expect(server.waits_ms).toEqual([2000]);
});

test("another answer that is there already stays, and the trial is done", async () => {
  const server = new Server();
  server.taken = [answer(0, "right")];
  const sender = server.sender();
  sender.add(answer(0, "left"), answer(1));
  await sender.settled();
  expect(server.taken.map(({ chosen }) => chosen)).toEqual(["right", "left"]);
  expect(sender.conflicts).toEqual([0]);
});

test("a server that lost answers is given them again", async () => {
  const server = new Server([]);
  server.taken = [answer(0)]; // restored from a backup: trials 1 and 2 were acknowledged once
  server.log = [0, 1, 2, 3].map((trial) => answer(trial));
  const sender = server.sender();
  sender.add(answer(3), answer(4));
  await sender.settled();
  expect(server.taken.map(({ trial }) => trial)).toEqual([0, 1, 2, 3, 4]);
});

test("an answer that can never have its turn stops the sender instead of going round", async () => {
  const server = new Server();
  const sender = server.sender();
  sender.add(answer(3));
  await sender.settled();
  expect(server.refusal?.kind).toBe("turn");
  expect(server.attempts).toEqual([3]);
});

test("a refusal for good is told, and nothing more is sent", async () => {
  const server = new Server([new Problem("excluded", "not-allowed", 403)]);
  const sender = server.sender();
  sender.add(answer(0), answer(1));
  await sender.settled();
  sender.add(answer(2));
  await sender.settled();
  expect(server.refusal?.status).toBe(403);
  expect(server.attempts).toEqual([0]);
  expect(sender.waiting).toBe(3);
});

test("an answer added just as the last one has arrived is sent too", async () => {
  for (let moments = 0; moments < 10; moments += 1) {
    const server = new Server();
    const sender: Sender = server.sender(async () => {
      for (let moment = 0; moment < moments; moment += 1) await null;
      sender.add(answer(1));
    });
    sender.add(answer(0));
    await new Promise((resolve) => setTimeout(resolve, 5));
    expect(server.taken.map(({ trial }) => trial)).toEqual([0, 1]);
  }
});
