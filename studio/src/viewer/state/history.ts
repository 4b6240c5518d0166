/** What was before, and what was undone. */

/** So many steps are kept. */
const MOST = 300;
/** Changes by the same gesture are one step when they follow each other within this time. */
const TOGETHER_MS = 1000;

export interface History<T> {
  readonly past: readonly T[];
  readonly now: T;
  readonly future: readonly T[];
  /** What made the last step, and when in ms. */
  readonly gesture: string;
  readonly at: number;
}

export function begin<T>(now: T): History<T> {
  return { past: [], now, future: [], gesture: "", at: -Infinity };
}

/** One step on; several of one gesture, such as dragging a slider, are one. */
export function step<T>(history: History<T>, next: T, gesture: string, at: number): History<T> {
  const same = gesture !== "" && gesture === history.gesture && at - history.at < TOGETHER_MS;
  const past = same ? history.past : [...history.past, history.now].slice(-MOST);
  return { past, now: next, future: [], gesture, at };
}

export function undone<T>(history: History<T>): History<T> {
  const now = history.past.at(-1);
  if (now === undefined) return history;
  const future = [history.now, ...history.future];
  return { past: history.past.slice(0, -1), now, future, gesture: "", at: -Infinity };
}

export function redone<T>(history: History<T>): History<T> {
  const now = history.future[0];
  if (now === undefined) return history;
  const past = [...history.past, history.now];
  return { past, now, future: history.future.slice(1), gesture: "", at: -Infinity };
}
