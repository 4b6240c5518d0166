/** Opens one file: by the ending of its name, as the keys that name files do. */

import { ask } from "../light/desk";
import { type Complaint, type Read, type Specs, fromToml, label, open } from "../specs/spec";
import { type Dropped, droppedNames, keepDropped } from "./dropped";
import { opened } from "./opened";
import { announce, edit, editScene, notice, side, specs, take } from "./store";
import { fileWord } from "../words/files";

type Bytes = Uint8Array<ArrayBuffer>;

/** TOML files beyond this are none of ours; of other files `specs` and `crates/file` say what they take. */
const MOST_TOML = 2_000_000;
const MOST_TABLE = 1_000_000;
/** A page holds a file whole, and its pixels too. */
const MOST_BYTES = 2 ** 27;
const MOST_PIXELS = 2 ** 23;

const PANORAMAS = [".hdr", ".exr"];
const PHOTOGRAPHS = [".png", ".jpg", ".jpeg", ".tif", ".tiff"];

/** Takes a file; gives what is wrong with it. */
export async function openFile(file: File): Promise<readonly Complaint[]> {
  const where = label(file.name);
  try {
    const ending = /\.[^.]*$/.exec(file.name.toLowerCase())?.[0] ?? "";
    const isPicture = PANORAMAS.includes(ending) || PHOTOGRAPHS.includes(ending);
    if (isPicture && file.size > MOST_BYTES) {
      return told(
        `${where}: is ${file.size} bytes long; allowed on this page: at most ${MOST_BYTES}`,
      );
    }
    if (ending === ".csv") return await openLight(file);
    if (!isPicture) return openToml(await bytesOf(file, MOST_TOML), file.name);
    const bytes = await bytesOf(file, MOST_BYTES);
    if (PHOTOGRAPHS.includes(ending)) return await openPhotograph(bytes, file.name);
    return ending === ".hdr"
      ? await openPanorama(bytes, file.name)
      : await openExr(bytes, file.name);
  } catch (error) {
    const text = (error as Error).message;
    return told(text.startsWith(where) ? text : `${where}: ${text}`);
  }
}

async function bytesOf(file: File, most: number): Promise<Bytes> {
  try {
    return new Uint8Array(await file.slice(0, most + 1).arrayBuffer());
  } catch {
    throw new Error("cannot be read"); // a folder, or a file that changed since
  }
}

function told(text: string): readonly Complaint[] {
  return [{ path: "", text }];
}

function openToml(bytes: Bytes, name: string): readonly Complaint[] {
  const read = open(bytes, name, droppedNames.value);
  if (!read.ok) return read.complaints;
  if (read.value.kind === "pearl") take("pearl", read.value.spec);
  else take("scene", read.value.spec);
  return [];
}

/** The kind of each that a key takes, and under which name. */
type Kept = Dropped extends infer D
  ? D extends Dropped
    ? Omit<D, "name" | "serial" | "sha256">
    : never
  : never;

let serial = 0;

async function keep(bytes: Bytes, name: string, kept: Kept): Promise<void> {
  const subtle = crypto.subtle as SubtleCrypto | undefined;
  const digest = await subtle?.digest("SHA-256", bytes);
  const hex = (byte: number) => byte.toString(16).padStart(2, "0");
  const sha256 = digest && Array.from(new Uint8Array(digest), hex).join("");
  serial += 1;
  keepDropped({ ...kept, name, serial, sha256: sha256 ?? null } as Dropped);
}

/** A measured light: all lamps and windows shine with it. */
async function openLight(file: File): Promise<readonly Complaint[]> {
  const bytes = await bytesOf(file, MOST_TABLE);
  const where = label(file.name);
  if (bytes.length > MOST_TABLE) return told(`${where}: more than 1 MB; allowed: up to 1 MB`);
  const text = tableText(bytes);
  if (text === null)
    return told(`${where}: not text; allowed: a table in UTF-8, UTF-16 or Latin-1`);
  const values = await ask("light", { text, place: file.name });
  await keep(bytes, file.name, { kind: "light", values });
  const { lamps, windows } = specs.value.scene;
  const lights = [
    ...lamps.map((_, i) => `lamps.${i}.spectrum`),
    ...windows.map((_, i) => `windows.${i}.spectrum`),
  ];
  editScene("light", Object.fromEntries(lights.map((path) => [path, file.name])));
  if (lights.length > 0) announce(fileWord("tookLight", { name: file.name }));
  else notice.value = fileWord("noLight", { name: file.name });
  return [];
}

/** `nacreous/file.py` `read_text`: UTF-16 where it says so, else UTF-8, else Latin-1; null of no text. */
function tableText(bytes: Bytes): string | null {
  const [a, b] = bytes;
  const marked = (a === 0xff && b === 0xfe) || (a === 0xfe && b === 0xff);
  const decoders = marked
    ? [decoded(a === 0xff ? "utf-16le" : "utf-16be")]
    : [decoded("utf-8"), latin];
  for (const decode of decoders) {
    const text = decode(bytes)?.replace(/\r\n?/g, "\n");
    if (text !== undefined && !/[^\P{Cc}\t\n\r\f]/u.test(text)) return text;
  }
  return null;
}

function decoded(encoding: string) {
  return (bytes: Bytes): string | undefined => {
    try {
      return new TextDecoder(encoding, { fatal: true }).decode(bytes);
    } catch {
      return undefined;
    }
  };
}

/** A browser's latin1 is Windows' own. */
function latin(bytes: Bytes): string {
  return Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
}

async function openPanorama(bytes: Bytes, name: string): Promise<readonly Complaint[]> {
  const { width, height, rgb } = await ask("panorama", { bytes });
  if (width * height > MOST_PIXELS) {
    throw new Error(
      `is ${width} x ${height} pixels; allowed on this page: at most ${MOST_PIXELS} pixels in all`,
    );
  }
  await keep(bytes, name, { kind: "panorama", panorama: { name, width, height, rgb } });
  editScene("panorama", { "sky.kind": "panorama", "sky.path": name });
  announce(fileWord("tookPanorama", { name }));
  return [];
}

/** A PNG of ours offers its recipe; every other picture is one of grain. */
async function openPhotograph(bytes: Bytes, name: string): Promise<readonly Complaint[]> {
  if (name.toLowerCase().endsWith(".png")) {
    const texts = await ask("pngTexts", { bytes }).catch(() => []);
    const embedded = embeddedSpecs(texts, name);
    if (embedded?.ok) {
      opened.value = {
        name,
        layers: null,
        specs: embedded.value,
        complaints: [],
        photograph: bytes,
      };
      return [];
    }
    if (embedded !== null) return embedded.complaints;
  }
  return takeGrain(bytes, name);
}

/** Takes a picture as a photograph of the pearl's grain, if its grain can be measured. */
export async function takeGrain(bytes: Bytes, name: string): Promise<readonly Complaint[]> {
  const { side_px, mm_per_pixel, low_per_mm, high_per_mm } = specs.value.pearl.texture;
  try {
    const how = { side_px, mm_per_pixel, low_per_mm, high_per_mm };
    await ask("grain", { bytes, how });
  } catch (error) {
    const text = (error as Error).message;
    const isNoPearl = text.startsWith("texture: no patch");
    const why = isNoPearl
      ? `no pearl found in it; wanted: a photograph of one pearl, with ${side_px} x ${side_px} pixels of it or more without highlight`
      : text.replace(/^texture: /, "");
    return told(`${label(name)}: ${why}`);
  }
  await keep(bytes, name, { kind: "photograph", bytes });
  edit("pearl", "texture.source", name);
  announce(fileWord("tookGrain", { name }));
  return [];
}

/** An OpenEXR file is a picture of ours, a panorama, or whatever else has layers. */
async function openExr(bytes: Bytes, name: string): Promise<readonly Complaint[]> {
  let why = "";
  const layers = await ask("exr", { bytes }).catch((error: unknown) => {
    why = (error as Error).message;
    return null;
  });
  const embedded = layers === null ? null : embeddedSpecs(layers.texts, name);
  const isOurs = layers?.texts.some(([keyword]) => keyword.startsWith("nacreous:")) === true;
  if (layers !== null && isOurs) {
    const specs = embedded?.ok ? embedded.value : null;
    const complaints = embedded?.ok === false ? embedded.complaints : [];
    opened.value = { name, layers, specs, complaints, photograph: null };
    return [];
  }
  if (why.startsWith("holds spectra")) throw new Error(why);
  try {
    return await openPanorama(bytes, name);
  } catch (error) {
    if (layers === null) throw error;
    opened.value = { name, layers, specs: null, complaints: [], photograph: null };
    return [];
  }
}

/** `nacreous/embedded.py`: pearl and scene of a picture's texts; null where it holds none of them. */
function embeddedSpecs(
  texts: readonly (readonly [string, string])[],
  name: string,
): Read<Specs> | null {
  const found = new Map(texts.map(([keyword, text]) => [keyword.replace(/^nacreous:/, ""), text]));
  if (!texts.some(([keyword]) => keyword.startsWith("nacreous:"))) return null;
  const where = label(name);
  const refuse = (text: string): Read<Specs> => ({ ok: false, complaints: told(text) });
  if (found.has("pearl.0")) {
    return refuse(`${where}: holds several pearls; allowed on this page: a picture of one`);
  }
  const [pearlText, sceneText] = [found.get("pearl"), found.get("scene")];
  if (pearlText === undefined || sceneText === undefined) {
    return refuse(
      `${where}: has no recipe; allowed: a picture that nacreous render made, unchanged`,
    );
  }
  const files = droppedNames.value;
  const pearl = fromToml("pearl", pearlText, `${name}: pearl`, files);
  const scene = fromToml("scene", withOneStar(sceneText), `${name}: scene`, files);
  if (!pearl.ok || !scene.ok) {
    const complaints = [pearl, scene].flatMap((one) => (one.ok ? [] : one.complaints));
    return { ok: false, complaints };
  }
  return { ok: true, value: { pearl: pearl.value, scene: scene.value } };
}

/** Rows of a recipe name pearls by number; of one alone that is any pearl. */
function withOneStar(text: string): string {
  return text.replaceAll('"*0"', '"*"');
}

/** Takes pearl and scene from the picture that is open. */
export function takeOpened(): void {
  const found = opened.value?.specs;
  if (found === null || found === undefined) return;
  take("pearl", found.pearl);
  take("scene", found.scene);
  notice.value = fileWord("tookRecipe", { name: side.value.specs.pearl.name });
  opened.value = null;
}
