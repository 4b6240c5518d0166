/** What the page shows, and the few ways to change it. */

import { batch, computed, signal } from "@preact/signals";
import {
  type Complaint,
  type Kind,
  PEARLS,
  type Pearl,
  SCENES,
  type Scene,
  type Specs,
} from "../specs/spec";
import { faultsIn } from "./faults";
import { type History, begin, redone, step, undone } from "./history";
import { valueAt, withValue } from "./path";

/** A pearl in its scene, and what both were before they were changed. */
export interface Side {
  readonly specs: Specs;
  readonly origin: Specs;
}

/** What is compared; B is there only while something is. */
export interface Board {
  readonly a: Side;
  readonly b: Side | null;
}

export type Which = "a" | "b";

function first(): Board {
  const pearl = PEARLS.get("akoya-rg");
  const scene = SCENES.get("north-window-black");
  if (pearl === undefined || scene === undefined) throw new Error("the presets are not there");
  const specs = { pearl, scene };
  return { a: { specs, origin: specs }, b: null };
}

const history = signal<History<Board>>(begin(first()));

export const board = computed(() => history.value.now);
export const canUndo = computed(() => history.value.past.length > 0);
export const canRedo = computed(() => history.value.future.length > 0);

/** The side that the knobs turn. */
export const active = signal<Which>("a");
export const side = computed<Side>(() =>
  active.value === "b" && board.value.b !== null ? board.value.b : board.value.a,
);
export const specs = computed(() => side.value.specs);

/** Whether a hand is on a knob: then first pictures only. */
export const moving = signal(false);
/** What is wrong with a file or link that was therefore not taken. */
export interface Refused {
  readonly from: "file" | "link";
  readonly complaints: readonly Complaint[];
}
export const refused = signal<Refused | null>(null);
/** What is wrong with the active pearl and its scene as they stand. */
export const faults = computed(() => faultsIn(specs.value));
/** What the open keys of the active pearl come to. */
export const resolved = signal<Readonly<Record<string, number>>>({});
/** One short message, spoken by screen readers too. */
export const notice = signal("");
/** What a notice offers to be undone: only while nothing was changed since. */
const taken = signal<{ readonly said: string; readonly board: Board } | null>(null);
export const offersUndo = computed(
  () => taken.value?.said === notice.value && taken.value.board === board.value,
);

/** Says what was just done, and offers to undo it. */
export function announce(said: string): void {
  batch(() => {
    notice.value = said;
    taken.value = { said, board: board.value };
  });
}

/** How long after its last event a hand is said to rest, in ms. */
const REST_MS = 100;
let resting: ReturnType<typeof setTimeout> | undefined;

/** Says that a hand is on a knob; it rests a moment after the last of these. */
export function touch(): void {
  moving.value = true;
  clearTimeout(resting);
  resting = setTimeout(() => (moving.value = false), REST_MS);
}

function change(next: Board, gesture: string): void {
  history.value = step(history.value, next, gesture, performance.now());
}

/** Whether scene and camera of both sides change together. */
export const together = signal(true);

function put(next: Side, gesture: string): void {
  const { a, b } = board.value;
  if (b === null) return change({ a: next, b }, gesture);
  const isScene = together.value && next.specs.scene !== side.value.specs.scene;
  const along = (other: Side): Side =>
    isScene
      ? {
          specs: { ...other.specs, scene: next.specs.scene },
          origin: { ...other.origin, scene: next.origin.scene },
        }
      : other;
  change(active.value === "b" ? { a: along(a), b: next } : { a: next, b: along(b) }, gesture);
}

/** Sets one key. */
export function edit(kind: Kind, path: string, value: unknown): void {
  const now = side.value;
  const next = { ...now.specs, [kind]: withValue(now.specs[kind], path, value) };
  batch(() => {
    put({ ...now, specs: next }, `${kind}.${path}`);
    refused.value = null;
    touch();
  });
}

/** Sets several keys of the scene by one gesture. */
export function editScene(gesture: string, values: Readonly<Record<string, unknown>>): void {
  const now = side.value;
  let scene = now.specs.scene;
  for (const [path, value] of Object.entries(values)) scene = withValue(scene, path, value);
  put({ ...now, specs: { ...now.specs, scene } }, gesture);
  touch();
}

/** Puts another pearl or another scene in the place of this one. */
export function take(kind: "pearl", spec: Pearl): void;
export function take(kind: "scene", spec: Scene): void;
export function take(kind: Kind, spec: Pearl | Scene): void {
  const now = side.value;
  batch(() => {
    put(
      {
        specs: { ...now.specs, [kind]: spec },
        origin: { ...now.origin, [kind]: spec },
      },
      "",
    );
    refused.value = null;
  });
}

/** Begins anew with what a link holds; there is nothing before it to go back to. */
export function beginWith(both: Specs): void {
  batch(() => {
    history.value = begin<Board>({ a: { specs: both, origin: both }, b: null });
    active.value = "a";
    refused.value = null;
  });
}

/** The value that a key was given by the preset or file. */
export function originAt(kind: Kind, path: string): unknown {
  return valueAt(side.value.origin[kind], path);
}

/** Everything as the preset or file had it. */
export function resetAll(): void {
  batch(() => {
    put({ ...side.value, specs: side.value.origin }, "");
    refused.value = null;
    notice.value = ""; // it told of what is no more
  });
}

export function undo(): void {
  goTo(undone(history.value));
}

export function redo(): void {
  goTo(redone(history.value));
}

function goTo(step: History<Board>): void {
  batch(() => {
    history.value = step;
    refused.value = null;
    notice.value = ""; // it told of what is no more
    if (board.value.b === null) active.value = "a";
  });
}

/** Begins to compare: B is what A is now, and the knobs turn B. */
export function compare(): void {
  const { a } = board.value;
  batch(() => {
    change({ a, b: a }, "");
    active.value = "b";
  });
}

/** Ends comparing; what is kept is the active side. */
export function compareNoMore(): void {
  batch(() => {
    change({ a: side.value, b: null }, "");
    active.value = "a";
    notice.value = ""; // it told of B
  });
}
