import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { bugbot } from "./site/build/plugin.mjs";

/** @param {string} path */
const page = (path) => fileURLToPath(new URL(`site/${path}`, import.meta.url));

export default defineConfig({
  root: "site",
  // Relative addresses: the built site works from any folder of any host.
  base: "./",
  appType: "mpa",
  plugins: [bugbot()],
  worker: { format: "es" },
  build: {
    outDir: "../dist",
    emptyOutDir: true,
    target: "es2022",
    // A data: address in a script would need a wider Content-Security-Policy.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // The editor with the language and the chart is one part, loaded only by pages with a lab.
    chunkSizeWarningLimit: 800,
    rollupOptions: {
      input: {
        home: page("index.html"),
        lab: page("lab/index.html"),
        worlds: page("worlds/index.html"),
        api: page("api/index.html"),
      },
    },
  },
  server: { host: "127.0.0.1" },
  preview: { host: "127.0.0.1", port: 4173, strictPort: true },
});
