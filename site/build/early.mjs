/**
 * The first script of every page (site/src/early), written into the page itself, with the policy
 * that lets this one script run and no other. And the ends by which that script knows a page and a
 * style sheet as whole.
 */
import { createHash } from "node:crypto";
import { join } from "node:path";
import { contentSecurityPolicy } from "./csp.mjs";
import { ROOT } from "./files.mjs";
import { standalone } from "./standalone.mjs";

/** The id at the end of a page, and the selector of a style sheet's last rule. */
const END = "whole";

/** @returns {import("vite").Plugin} */
export function early() {
  let dev = false;
  /** @type {Promise<string> | undefined} */
  let making;
  const script = () => {
    making ??= standalone(join(ROOT, "site/src/early/early.ts")).then((code) => code.trim());
    return making;
  };
  return {
    name: "bugbot-early",

    config(_config, { command }) {
      dev = command === "serve";
    },

    async transformIndexHtml(html) {
      const code = await script();
      // After the encoding, which has to stand among a page's first thousand bytes.
      const charset = /<meta charset="utf-8" ?\/?>/;
      if (!charset.test(html))
        throw new Error("a page has no <meta charset> to put a script behind");
      const inPage = html.replace(charset, (meta) => `${meta}\n    <script>${code}</script>`);
      const end = { tag: "template", attrs: { id: END }, injectTo: /** @type {const} */ ("body") };
      // The development server needs inline scripts and a web socket for live reload.
      if (dev) return { html: inPage, tags: [end] };
      const hash = createHash("sha256").update(code).digest("base64");
      const content = contentSecurityPolicy([`'sha256-${hash}'`]);
      const attrs = { "http-equiv": "Content-Security-Policy", content };
      return { html: inPage, tags: [{ tag: "meta", attrs, injectTo: "head-prepend" }, end] };
    },

    generateBundle: {
      order: "post",
      handler(_options, bundle) {
        for (const file of Object.values(bundle)) {
          if (file.type !== "asset" || !file.fileName.endsWith(".css")) continue;
          const text = Buffer.from(file.source).toString().trimEnd();
          // A rule that says something, lest a host's own minifier leave it out.
          file.source = `${text}\n#${END}{display:none}\n`;
        }
      },
    },
  };
}
