/** The renderer, fetched and compiled once for all workers. */

import filesFile from "nacreous-files-file?url";
import file from "nacreous-wasm-file?url";

let compiled: Promise<WebAssembly.Module> | null = null;
let codecs: Promise<WebAssembly.Module> | null = null;

export function program(): Promise<WebAssembly.Module> {
  compiled ??= fetched(file);
  return compiled;
}

/** The codecs of pictures, fetched when the first file is opened or saved. */
export function filesProgram(): Promise<WebAssembly.Module> {
  codecs ??= fetched(filesFile);
  codecs.catch(() => (codecs = null)); // a lost connection may come back
  return codecs;
}

async function fetched(place: string): Promise<WebAssembly.Module> {
  const response = await fetch(place);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  // a web host need not know what the file's kind is
  return WebAssembly.compile(await response.arrayBuffer());
}
