import { defineConfig } from "vitest/config";

// The server's content policy allows files of its own and nothing inline: so no data: URLs either.
export default defineConfig({
  build: {
    outDir: "../nacreous/server/pages",
    emptyOutDir: true,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    rolldownOptions: { input: ["index.html", "lab.html"] },
  },
  // For work on the pages: `npm run dev`, beside `nacreous study serve` on its usual port.
  server: { proxy: { "/api": "http://127.0.0.1:8000", "/lab/api": "http://127.0.0.1:8000" } },
  test: { include: ["tests/**/*.test.ts"], environment: "happy-dom" },
});
