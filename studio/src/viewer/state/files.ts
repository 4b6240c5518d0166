/** Files and links, in and out. */

import { ask } from "../light/desk";
import {
  type Complaint,
  type Specs,
  fromFragment,
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
import { beginWith, notice, refused, specs } from "./store";

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

/** The canvas's own values; nothing is drawn anew. */
export function savePng(canvas: HTMLCanvasElement, name: string): void {
  canvas.toBlob((blob) => {
    if (blob !== null) saveAs(`${name}.png`, blob);
  }, "image/png");
}

/** So many files are taken at once. */
const MOST_FILES = 8;

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
  const files = new Map(
    namedBy(now).flatMap((one) => (one.sha256 === null ? [] : [[one.name, one.sha256]])),
  );
  const { resources } = resourcesOf(now);
  notice.value = fileWord("saving");
  try {
    const recipe = recipeJson(now, sizePx, samples);
    const bytes = await ask("save", { recipe, resources, samples, ...recipeTexts(now, files) });
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
    notice.value =
      names.length > 0 ? fileWord("linkWithout", { names: names.join(", ") }) : said.copied;
  } catch {
    notice.value = said.shown;
  }
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
