/** Asks a worker of its own for each file, so that nothing a file does outlives it. */

import { filesProgram, program } from "./program";
import type { Answer, Ask, Request, Requests } from "./requests";

/** Whatever takes longer than this will not end. */
const MOST_MS = 180_000;

/** Requests that the renderer's program answers, and those that both do. */
const RENDERS: readonly Request[] = ["difference", "save"];
const READS_NO_FILE: readonly Request[] = ["difference"];

/** The answer, or an Error with one line. */
export async function ask<R extends Request>(
  kind: R,
  given: Requests[R][0],
): Promise<Requests[R][1]> {
  const message: Ask<R> = {
    kind,
    given,
    program: RENDERS.includes(kind) ? await program() : null,
    files: READS_NO_FILE.includes(kind) ? null : await filesProgram(),
  };
  const worker = new Worker(new URL("./desk.worker.ts", import.meta.url), { type: "module" });
  try {
    return await new Promise<Requests[R][1]>((done, fail) => {
      const late = () => fail(new Error("takes too long"));
      const timer = setTimeout(late, MOST_MS);
      worker.onmessage = ({ data }: MessageEvent<Answer>) => {
        clearTimeout(timer);
        if (data.ok) done(data.value);
        else fail(new Error(data.text));
      };
      worker.onerror = (event) => {
        clearTimeout(timer);
        fail(new Error(event.message || "a worker could not start"));
      };
      worker.onmessageerror = () => fail(new Error("takes more memory than this page has"));
      worker.postMessage(message);
    });
  } finally {
    worker.terminate();
  }
}
