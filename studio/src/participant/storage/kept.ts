/** What this browser holds of a study: its token, its answers, and what the screen is like. */

import type { ScreenContent } from "../screen/content";
import { openDatabase, read, write } from "./database";
import { LastingLog, PassingLog } from "./log";
import type { Log } from "./log";

/** The token that came with the link, behind the #; null where there is none. */
export function linked(hash: string): string | null {
  const token = hash.replace(/^#/, "");
  return /^[\w-]{16,200}$/.test(token) ? token : null;
}

export class Kept {
  private constructor(private readonly database: IDBDatabase | null) {}

  /** Open it; where the browser keeps nothing, nothing is kept. */
  static async open(): Promise<Kept> {
    return new Kept(await openDatabase().catch(() => null));
  }

  /** The token that was kept under a name (`placesOf`). */
  async token(place: string): Promise<string | null> {
    if (this.database === null) return null;
    const token: unknown = await read(this.database, "tokens", (store) => store.get(place));
    return typeof token === "string" ? token : null;
  }

  /**
   * Keep the token before it is used, and take it out of the address: an address is shown, saved
   * and sent on. Where nothing is kept, the address is the only place that a reload can find.
   */
  async keepToken(places: string[], token: string): Promise<void> {
    const { database } = this;
    for (const one of places) {
      if (database !== null) await write(database, "tokens", (store) => store.put(token, one));
    }
    const place = location.pathname + location.search;
    history.replaceState(null, "", database === null ? `${place}#${token}` : place);
  }

  /** Forget it, so that another person can begin here; the answers given so far stay. */
  async forgetToken(places: string[]): Promise<void> {
    const { database } = this;
    for (const one of places) {
      if (database !== null) await write(database, "tokens", (store) => store.delete(one));
    }
    history.replaceState(null, "", location.pathname + location.search);
  }

  async screen(token: string): Promise<ScreenContent | null> {
    if (this.database === null) return null;
    const kept: unknown = await read(this.database, "screens", (store) => store.get(token));
    return (kept as ScreenContent | undefined) ?? null;
  }

  async keepScreen(token: string, content: ScreenContent): Promise<void> {
    const { database } = this;
    if (database !== null) await write(database, "screens", (store) => store.put(content, token));
  }

  /** The tokens of sittings that were begun in this browser and not seen to their end. */
  async unfinished(): Promise<string[]> {
    if (this.database === null) return [];
    const tokens = await read(this.database, "screens", (store) => store.getAllKeys());
    return tokens.map(String);
  }

  /** Everything is at the server; nothing more is asked of this sitting's screen. */
  async finish(token: string): Promise<void> {
    const { database } = this;
    if (database !== null) await write(database, "screens", (store) => store.delete(token));
  }

  /**
   * The log of a sitting, by the name that the server gives it. Not by the token: a store that went
   * back to a backup, or an erased person's link, makes another sitting of the same one, in which
   * other pictures stand left and right, and to which no earlier answer belongs.
   */
  log(sitting: string): Log {
    return this.database === null ? new PassingLog() : new LastingLog(this.database, sitting);
  }
}
