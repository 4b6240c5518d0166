/** Requests that are made again until the server answers. */

import { Problem } from "../shared/http";
import { backoff_ms } from "./storage/sender";

/** Wait, but no longer than until the browser says that the network is back. */
export function pause(wait_ms: number): Promise<void> {
  return new Promise((resolve) => {
    const end = () => {
      clearTimeout(clock);
      removeEventListener("online", end);
      resolve();
    };
    const clock = setTimeout(end, wait_ms);
    addEventListener("online", end);
  });
}

/** What `request` brings; `connected` is told after each attempt whether it reached the server. */
export async function reach<T>(
  request: () => Promise<T>,
  connected: (yes: boolean) => void,
): Promise<T> {
  for (let failures = 1; ; failures += 1) {
    try {
      const brought = await request();
      connected(true);
      return brought;
    } catch (reason) {
      if (!(reason instanceof Problem) || !reason.passes) throw reason;
      connected(false);
      await pause(Math.max(reason.retryAfterMs, backoff_ms(failures)));
    }
  }
}
