/** One sitting, one tab: a second one is told, so that no two give answers to the same trial. */

const WAIT_MS = 400;

interface Word {
  from: number;
  says: "who is here" | "I am";
}

/**
 * Resolves to whether this tab may go on. Tabs that were here before answer; of two that open at
 * the same moment the one with the smaller number goes on.
 */
export function claim(sitting: string): Promise<boolean> {
  const channel = new BroadcastChannel(`nacreous ${sitting}`);
  const own = Math.random();
  const tell = (says: Word["says"]) => channel.postMessage({ from: own, says } satisfies Word);
  return new Promise((resolve) => {
    let here = false;
    const yieldTo = () => {
      clearTimeout(clock);
      channel.close();
      resolve(false);
    };
    channel.onmessage = ({ data }: MessageEvent<Word>) => {
      if (data.says === "who is here" && (here || own < data.from)) tell("I am");
      else if (!here) yieldTo();
    };
    const clock = setTimeout(() => {
      here = true;
      resolve(true);
    }, WAIT_MS);
    tell("who is here");
  });
}
