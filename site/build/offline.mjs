/**
 * What lets the built site be kept on a device: the service worker with the list of every file and
 * its hash, the icons, and the manifest that lets the site be installed like an app.
 *
 * It goes last and looks at what has been written, so it needs no list of what the site has.
 */
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { filesBelow, ROOT, sha256 } from "./files.mjs";
import { iconFiles } from "./icons.mjs";
import { toRoot } from "./lessons/site-frame.mjs";
import { standalone } from "./standalone.mjs";

const WORKER = "sw.js";
const MANIFEST = "manifest.webmanifest";

/** What only other sites, or only the browser itself, asks for. */
const NOT_KEPT = [WORKER, "embed.js", "map.png", "sitemap.xml"];

/** The light and the dark paper of tokens.css. */
const PAPER = { light: "#fbfaf7", dark: "#15181c" };

/** Addresses are relative: the site may lie in any folder of a host. */
const APP = {
  name: "bugbot lessons",
  short_name: "bugbot",
  description: "Occupancy grid mapping, taught with Python programs that run in the page",
  lang: "en-GB",
  start_url: "./",
  scope: "./",
  display: "standalone",
  background_color: PAPER.light,
  theme_color: PAPER.light,
  categories: ["education"],
  icons: [
    { src: "icon-192.png", sizes: "192x192", type: "image/png" },
    { src: "icon-512.png", sizes: "512x512", type: "image/png" },
    { src: "icon-maskable-512.png", sizes: "512x512", type: "image/png", purpose: "maskable" },
  ],
};

/** @returns {import("vite").Plugin} */
export function offline() {
  return {
    name: "bugbot-offline",
    apply: "build",

    transformIndexHtml(_html, { path }) {
      const root = toRoot(path.replace(/^\//, ""));
      return [
        link({ rel: "manifest", href: `${root}${MANIFEST}` }),
        link({ rel: "apple-touch-icon", href: `${root}apple-touch-icon.png` }),
        ...Object.entries(PAPER).map(([scheme, content]) => ({
          tag: "meta",
          attrs: { name: "theme-color", media: `(prefers-color-scheme: ${scheme})`, content },
          injectTo: /** @type {const} */ ("head"),
        })),
      ];
    },

    generateBundle() {
      this.emitFile({ type: "asset", fileName: MANIFEST, source: JSON.stringify(APP) });
      for (const [fileName, source] of iconFiles()) {
        this.emitFile({ type: "asset", fileName, source });
      }
    },

    writeBundle: {
      order: "post",
      sequential: true,
      async handler({ dir = "" }) {
        const script = await standalone(join(ROOT, "site/src/offline/service-worker.ts"));
        const site = siteFiles(dir);
        writeFileSync(join(dir, WORKER), `const SITE_FILES=${JSON.stringify(site)};\n${script}`);
      },
    },
  };
}

/**
 * Every file of the built site that is kept on devices, with its size and hash.
 * @param {string} folder
 * @returns {import("../src/offline/site-files.ts").SiteFiles}
 */
export function siteFiles(folder) {
  const paths = filesBelow(folder, (path) => !NOT_KEPT.includes(path));
  const files = Object.fromEntries(
    paths.map((path) => {
      const data = readFileSync(join(folder, path));
      // In the form in which a browser is told what to expect of a file.
      const hash = createHash("sha256").update(data).digest("base64");
      return [path, { bytes: data.length, sha256: hash }];
    }),
  );
  return { version: sha256(JSON.stringify(files)).slice(0, 12), files };
}

/** @param {Record<string, string>} attrs */
function link(attrs) {
  return { tag: "link", attrs, injectTo: /** @type {const} */ ("head") };
}
