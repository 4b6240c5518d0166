/**
 * Both specs in the fragment of an address, which a browser never sends: what differs from a preset,
 * deflated, as letters that every address may have. Files that were dropped onto the page are not in
 * it.
 *
 * `1.` and base64url of zlib's form of `[pearl preset, what differs, scene preset, what differs]`.
 */

import { difference, laidOver } from "./difference";
import { ownKeys } from "./model";
import { PEARLS, SCENES } from "./presets";
import { read, refused } from "./read";
import type { Complaint, Pearl, Read, Scene, Specs } from "./types";

const VERSION = "1.";
/** Of a link, and of what it unfolds to: a pearl of 5000 listed layers takes 100 kB. */
const MOST_LETTERS = 400_000;
const MOST_BYTES = 1_000_000;

class TooLarge extends Error {}

/** The fragment, without its `#`. */
export async function toFragment({ pearl, scene }: Specs): Promise<string> {
  const text = JSON.stringify([
    ...nearest(PEARLS, pearl, (base) => basePearl(base, pearl.model)),
    ...nearest(SCENES, scene, (base) => base),
  ]);
  const deflated = await through(
    new CompressionStream("deflate"),
    new TextEncoder().encode(text),
    Number.POSITIVE_INFINITY,
  );
  return VERSION + toLetters(deflated);
}

/** The specs of a fragment; of a damaged one, one complaint. `files`: those dropped onto the page. */
export async function fromFragment(
  fragment: string,
  files?: ReadonlySet<string>,
): Promise<Read<Specs>> {
  const letters = fragment.replace(/^#/, "");
  if (!/^[0-9]{1,9}\./.test(letters)) return damaged("it does not begin with 1.");
  if (!letters.startsWith(VERSION)) return damaged("a newer Nacreous made it");
  if (letters.length > MOST_LETTERS) return damaged(`it is longer than ${MOST_LETTERS} letters`);
  const bytes = fromLetters(letters.slice(VERSION.length));
  if (!bytes) return damaged("it has letters that no link has");
  let parts: unknown;
  try {
    const inflated = await through(new DecompressionStream("deflate"), bytes, MOST_BYTES);
    parts = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(inflated));
  } catch (error) {
    const isLarge = error instanceof TooLarge;
    return damaged(
      isLarge ? `it holds more than ${MOST_BYTES} bytes` : "a part of it is missing or changed",
    );
  }
  return specsOf(parts, files);
}

function specsOf(parts: unknown, files?: ReadonlySet<string>): Read<Specs> {
  if (!Array.isArray(parts) || parts.length !== 4) return damaged("it holds no pearl and scene");
  const [pearlName, pearlChanges, sceneName, sceneChanges] = parts as unknown[];
  const pearlBase = PEARLS.get(String(pearlName));
  const sceneBase = SCENES.get(String(sceneName));
  if (!pearlBase || !sceneBase) return damaged("it is of a preset that is not here");
  const base = basePearl(pearlBase, (pearlChanges as { model?: unknown } | null)?.model);
  const pearl = read("pearl", laidOver(base, pearlChanges), "the link's pearl", files);
  if (!pearl.ok) return oneOf(pearl.complaints);
  const scene = read("scene", laidOver(sceneBase, sceneChanges), "the link's scene", files);
  if (!scene.ok) return oneOf(scene.complaints);
  return { ok: true, value: { pearl: pearl.value, scene: scene.value } };
}

/** Of a preset with the other model, what a pearl of this model has too. */
function basePearl(base: Pearl, model: unknown): Pearl {
  const isOther = (model === "transport" || model === "illuminant") && model !== base.model;
  return isOther ? ownKeys(base, "Pearl", model) : base;
}

/** The preset from which the least differs, and that. */
function nearest<T extends Pearl | Scene>(
  presets: ReadonlyMap<string, T>,
  spec: T,
  baseOf: (preset: T) => object,
): readonly [string, object] {
  let best: readonly [string, object] | undefined;
  let length = Number.POSITIVE_INFINITY;
  for (const [name, preset] of presets) {
    const found = difference(spec, baseOf(preset));
    const size = name.length + JSON.stringify(found).length;
    if (size < length) [best, length] = [[name, found], size];
  }
  if (!best) throw new Error("there are no presets");
  return best;
}

function damaged(why: string): Read<never> {
  return refused(`The link cannot be used: ${why}; wanted: a whole link, as it was copied`);
}

/** A link is no file that one could mend line by line. */
function oneOf(complaints: readonly Complaint[]): Read<never> {
  const [first, ...more] = complaints;
  const rest = more.length > 0 ? ` (and more)` : "";
  return { ok: false, complaints: first ? [{ ...first, text: first.text + rest }] : [] };
}

async function through(
  stream: GenericTransformStream,
  bytes: Uint8Array<ArrayBuffer>,
  most: number,
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes])
    .stream()
    .pipeThrough(stream)
    .getReader() as ReadableStreamDefaultReader<Uint8Array<ArrayBuffer>>;
  const chunks: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    chunks.push(next.value);
    size += next.value.length;
    if (size > most) {
      await reader.cancel().catch(() => undefined);
      throw new TooLarge();
    }
  }
  return new Uint8Array(await new Blob(chunks).arrayBuffer());
}

function toLetters(bytes: Uint8Array): string {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function fromLetters(letters: string): Uint8Array<ArrayBuffer> | undefined {
  if (!/^[A-Za-z0-9_-]+$/.test(letters)) return undefined;
  try {
    const binary = atob(letters.replaceAll("-", "+").replaceAll("_", "/"));
    return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
  } catch {
    return undefined;
  }
}
