/** A file's bytes and text, read with care: `nacreous/spec/document.py`. */

import { TomlError } from "./toml/error";
import { parseToml } from "./toml/parse";
import type { Read } from "./types";
import type { Table } from "./value";

/** Far above any pearl or scene: 5000 listed layers take 40 kB. */
export const MOST_BYTES = 1_000_000;

const LINE = 0x0a;

/** `_decoded`: the text; `where` names the file. */
export function bytesToText(bytes: Uint8Array, where: string): Read<string> {
  if (bytes.length > MOST_BYTES) {
    return refused(`${where}: is longer than ${MOST_BYTES} bytes, the most that is read`);
  }
  if (bytes.includes(0)) return refused(`${where}: is a binary file; wanted: a TOML file`);
  try {
    return { ok: true, value: new TextDecoder("utf-8", { fatal: true }).decode(bytes) };
  } catch {
    return refused(`${where}: line ${badLine(bytes)}: is not UTF-8; wanted: a TOML file`);
  }
}

/** No letter of UTF-8 goes over the end of a line. */
function badLine(bytes: Uint8Array): number {
  for (let line = 1, start = 0; ; line += 1) {
    const end = bytes.indexOf(LINE, start);
    if (end < 0) return line;
    try {
      new TextDecoder("utf-8", { fatal: true }).decode(bytes.subarray(start, end));
    } catch {
      return line;
    }
    start = end + 1;
  }
}

/** `parse`, and that there is a key at all. */
export function tomlTable(text: string, where: string): Read<Table> {
  let table: Table;
  try {
    table = parseToml(text);
  } catch (error) {
    if (!(error instanceof TomlError)) throw error;
    const at = error.place ? `line ${error.place.line}, column ${error.place.column}: ` : "";
    return refused(`${where}: ${at}${error.reason}`);
  }
  return table.size > 0
    ? { ok: true, value: table }
    : refused(`${where}: the file is empty; wanted: at least one key, such as name`);
}

function refused(text: string): Read<never> {
  return { ok: false, complaints: [{ path: "", text }] };
}
