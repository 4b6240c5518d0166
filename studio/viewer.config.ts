import { fileURLToPath } from "node:url";
import { type Plugin, defineConfig } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** A web host opens a folder by its index. */
const index: Plugin = {
  name: "index",
  enforce: "post",
  generateBundle(_options, bundle) {
    const page = bundle["viewer.html"];
    if (page !== undefined) page.fileName = "index.html";
  },
};

// Static files that any web host serves, from any folder; the content policy allows nothing inline.
export default defineConfig({
  base: "./",
  publicDir: false,
  plugins: [index],
  build: {
    outDir: "../nacreous/viewer/page",
    emptyOutDir: true,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    rolldownOptions: { input: "viewer.html" },
  },
  worker: { format: "es" },
  resolve: {
    alias: [
      { find: /^nacreous-wasm$/, replacement: here("../target/wasm/nacreous.js") },
      { find: /^nacreous-files$/, replacement: here("../target/wasm/nacreous_files.js") },
      {
        find: /^nacreous-files-file(?=\?|$)/,
        replacement: here("../target/wasm/nacreous_files_bg.wasm"),
      },
      { find: /^nacreous-wasm-file(?=\?|$)/, replacement: here("../target/wasm/nacreous_bg.wasm") },
    ],
  },
  server: { fs: { allow: [".."] } },
});
