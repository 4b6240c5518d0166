/** The renderer, fetched and compiled once for all workers. */

import file from "nacreous-wasm-file?url";

let compiled: Promise<WebAssembly.Module> | null = null;

export function program(): Promise<WebAssembly.Module> {
  compiled ??= fetch(file)
    .then((response) => {
      if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
      return response.arrayBuffer(); // a web host need not know what the file's kind is
    })
    .then((bytes) => WebAssembly.compile(bytes));
  return compiled;
}
