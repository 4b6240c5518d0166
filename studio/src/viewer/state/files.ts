/** Files and links, in and out. */

import { fromFragment, open, toFragment, toToml, type Specs } from "../specs/spec";
import { beginWith, notice, refused, specs, take } from "./store";

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

/** Files beyond this are none of ours. */
const MOST_BYTES = 2_000_000;

/** Takes pearl and scene files; what is wrong with one is told and nothing is changed by it. */
export async function openFiles(files: readonly File[]): Promise<void> {
  for (const file of files.slice(0, 8)) {
    const bytes = new Uint8Array(await file.slice(0, MOST_BYTES).arrayBuffer());
    const read = open(bytes, file.name);
    if (!read.ok) refused.value = { from: "file", complaints: read.complaints };
    else if (read.value.kind === "pearl") take("pearl", read.value.spec);
    else take("scene", read.value.spec);
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
    notice.value = said.copied;
  } catch {
    notice.value = said.shown;
  }
}

/** Takes what the address's fragment holds. */
export async function openLink(): Promise<void> {
  const fragment = location.hash.replace(/^#/, "");
  if (fragment === "") return;
  const read = await fromFragment(fragment);
  if (read.ok) beginWith(read.value);
  else refused.value = { from: "link", complaints: read.complaints };
}
