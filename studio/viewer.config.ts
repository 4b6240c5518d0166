import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

// Static files that any web host serves, from any folder; the content policy allows nothing inline.
export default defineConfig({
  base: "./",
  publicDir: false,
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
      { find: /^nacreous-wasm-file$/, replacement: here("../target/wasm/nacreous_bg.wasm") },
    ],
  },
  server: { fs: { allow: [".."] } },
});
