/** Files and links, in and out. */

import type { Space } from "nacreous-wasm";
import { ask } from "../light/desk";
import {
  type Complaint,
  type Specs,
  fromFragment,
  label,
  recipeJson,
  recipeTexts,
  toFragment,
  toToml,
} from "../specs/spec";
import { fileWord } from "../words/files";
import { refusalSays } from "../words/refusals";
import { droppedNames, namedBy } from "./dropped";
import { opened, openings, reading } from "./opened";
import { openFile } from "./opening";
import { resourcesOf } from "./resources";
import { active, beginWith, board, faults, notice, refused, specs } from "./store";

/** Offers a file to be saved. */
export function saveAs(name: string, contents: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(contents);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

export function saveToml(kind: "pearl" | "scene"): void {
  const spec = specs.value[kind];
  const text = kind === "pearl" ? toToml(kind, specs.value.pearl) : toToml(kind, specs.value.scene);
  saveAs(
    `${spec.name.replace(/[^\p{L}\p{N}._-]+/gu, "-")}.toml`,
    new Blob([text], { type: "application/toml" }),
  );
}

/** The canvas's own values; nothing is drawn anew. It keeps the recipe of what it shows. */
export async function savePng(canvas: HTMLCanvasElement, how: Shown): Promise<void> {
  const now = specs.value;
  const isWhole = faults.value.length === 0; // else the canvas shows what was before
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
  if (blob === null) return;
  const png = new Uint8Array(await blob.arrayBuffer());
  const marked = isWhole
    ? await ask("mark", { png, ...how, ...recipeTexts(now, heldBy(now)) }).catch(() => png)
    : png;
  saveAs(`${now.pearl.name}.png`, new Blob([marked], { type: "image/png" }));
}

/** What a picture on the page is made with, beside its specs. */
export interface Shown {
  readonly size: number;
  readonly samples: number;
  readonly space: Space;
}

/** What each dropped file that is named holds, as its SHA-256. */
function heldBy(now: Specs): ReadonlyMap<string, string> {
  const files = namedBy(now).flatMap(({ name, sha256 }) =>
    sha256 === null ? [] : [[name, sha256] as const],
  );
  return new Map(files);
}

/** So many files are taken at once. */
const MOST_FILES = 8;

function leftUnopened({ name }: File): Complaint {
  const text = `${label(name)}: was not opened; allowed: ${MOST_FILES} files at once`;
  return { path: "", text };
}

/**
 * Takes files, those first that others may name; what is wrong with one is told and nothing is changed
 * by it.
 */
export async function openFiles(files: readonly File[]): Promise<void> {
  const isToml = (file: File) => (/\.(csv|exr|hdr|jpe?g|png|tiff?)$/i.test(file.name) ? 0 : 1);
  const sorted = [...files.slice(0, MOST_FILES)].sort((a, b) => isToml(a) - isToml(b));
  opened.value = null;
  const isFromLink = refused.value?.from === "link";
  const before = droppedNames.value;
  const complaints: Complaint[] = [];
  for (const file of sorted) {
    reading.value = file.name;
    complaints.push(...(await openFile(file)));
  }
  complaints.push(...files.slice(MOST_FILES).map(leftUnopened));
  reading.value = "";
  openings.value += 1;
  if (complaints.length > 0) {
    refused.value = { from: "file", complaints };
    notice.value = ""; // of a file before it
  } else if (isFromLink && droppedNames.value !== before) await openLink(); // which may name one
}

/** Saves the active side's picture with its layers, as `nacreous render` makes it. */
export async function saveExr(sizePx: number, samples: number): Promise<void> {
  const now = specs.value;
  const { resources } = resourcesOf(now);
  notice.value = fileWord("saving");
  try {
    const recipe = recipeJson(now, sizePx, samples);
    const bytes = await ask("save", {
      recipe,
      resources,
      samples,
      ...recipeTexts(now, heldBy(now)),
    });
    saveAs(`${now.pearl.name}.exr`, new Blob([bytes], { type: "image/x-exr" }));
    notice.value = "";
  } catch (error) {
    const { lead, text } = refusalSays((error as Error).message);
    notice.value = lead + text;
  }
}

/** The address of these specs: they are in the fragment, which no server sees. */
export async function linkTo(which: Specs): Promise<string> {
  const url = new URL(location.href);
  url.hash = await toFragment(which);
  return url.href;
}

/** Keeps the address that of what is shown, so that loading the page again changes nothing. */
export async function keepAddress(): Promise<void> {
  history.replaceState(null, "", await linkTo(specs.value));
}

/** Copies the link; where the browser does not let us, it stands in the address bar. */
export async function copyLink(said: { copied: string; shown: string }): Promise<void> {
  await keepAddress();
  try {
    await navigator.clipboard.writeText(location.href);
    const names = namedBy(specs.value).map((one) => one.name);
    const told =
      names.length > 0 ? fileWord("linkWithout", { names: names.join(", ") }) : said.copied;
    notice.value = `${told}${ofOneSide()}`;
  } catch {
    notice.value = `${said.shown}${ofOneSide()}`;
  }
}

/** That a link holds one of two sides alone. */
function ofOneSide(): string {
  if (board.value.b === null) return "";
  const [side, other] = active.value === "b" ? ["B", "A"] : ["A", "B"];
  return fileWord("linkOfSide", { side, other });
}

/** Takes what the address's fragment holds. */
export async function openLink(): Promise<void> {
  const fragment = location.hash.replace(/^#/, "");
  if (fragment === "") return;
  const read = await fromFragment(fragment, droppedNames.value);
  if (read.ok) beginWith(read.value);
  else refused.value = { from: "link", complaints: read.complaints };
  openings.value += 1;
}
