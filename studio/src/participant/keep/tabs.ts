/** One sitting, one tab: a second one is told, so that no two give answers to the same trial. */

const WAIT_MS = 400;

interface Word {
  from: number;
  says: "who is here" | "I am";
}

/**
 * Resolves to whether this tab may go on. Tabs that were here before answer; of two that open at
 * the same moment one goes on.
 */
export function claim(sitting: string): Promise<boolean> {
  const channel = new BroadcastChannel(`nacreous ${sitting}`);
  const own = Math.random();
  let settled = false;
  const tell = (says: Word["says"]) => channel.postMessage({ from: own, says } satisfies Word);
  return new Promise((resolve) => {
    channel.onmessage = ({ data }: MessageEvent<Word>) => {
      if (data.says === "who is here") {
        if (settled || own < data.from) tell("I am");
      } else if (!settled) {
        settled = true;
        channel.close();
        resolve(false);
      }
    };
    tell("who is here");
    setTimeout(() => {
      if (settled) return;
      settled = true;
      resolve(true);
    }, WAIT_MS);
  });
}
