/**
 * npm run lesson:scorm -- SLUG [--site FOLDER] [--out FILE]: a lesson as a SCORM 1.2 package, for a
 * learning platform. Takes the pages from a built site: that of --site, or dist/, built first.
 *
 * In the package lie the lesson's page, the lab (lessons lead to it), all that the two load, the
 * script that talks with the platform (src/scorm) and the manifest. Links to other pages of the site
 * become plain text.
 */
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join, posix, resolve } from "node:path";
import { parseArgs } from "node:util";
import { filesBelow, messageOf, ROOT } from "./files.mjs";
import { ensureInstalled, fail } from "./install.mjs";

/** @typedef {{ path: string, data: Uint8Array }} PackedFile */

const LAB = "lab/index.html";
const ADAPTER = "scorm.js";

/** Not for a page in a frame: the site's own keeping of itself, and what others embed. */
const LEFT_OUT = /^(sw\.js|embed\.js|sitemap\.xml|.*\.webmanifest)$/;

/**
 * The files of the package, the manifest first. Throws if the site has no such lesson.
 * @param {string} slug
 * @param {string} site the folder of the built site
 * @returns {Promise<PackedFile[]>}
 */
export async function scormFiles(slug, site) {
  const page = `lessons/${slug}/index.html`;
  if (!existsSync(join(site, page))) {
    throw new Error(`the site has no page ${page}: name a lesson of lessons/course.json`);
  }
  const { standalone } = await import("./standalone.mjs");
  const adapter = await standalone(join(ROOT, "site/src/scorm/scorm.ts"));
  const pages = [page, LAB].filter((path) => existsSync(join(site, path)));
  const files = [
    ...pages.map((path) => ({
      path,
      data: Buffer.from(framed(readFileSync(join(site, path), "utf8"), path, pages)),
    })),
    ...neededBy(pages, site).map((path) => ({ path, data: readFileSync(join(site, path)) })),
    { path: ADAPTER, data: Buffer.from(adapter) },
  ];
  const title = titleOf(files[0]?.data.toString() ?? "");
  const paths = files.map(({ path }) => path);
  return [
    { path: "imsmanifest.xml", data: Buffer.from(manifest(slug, title, page, paths)) },
    ...files,
  ];
}

/**
 * All files that these pages name, and those that these name. The build's names are unlike any other
 * text (they end in a hash), so a file is needed if its name stands in one that is.
 * @param {readonly string[]} pages
 * @param {string} site
 */
function neededBy(pages, site) {
  // The frame that workers are made in is no page of the site's.
  const isPage = (/** @type {string} */ path) =>
    path.endsWith(".html") && !path.startsWith("assets/");
  const there = filesBelow(site, (path) => !isPage(path) && !LEFT_OUT.test(path));
  /** @type {Set<string>} */
  const needed = new Set();
  const waiting = [...pages];
  for (let path = waiting.pop(); path !== undefined; path = waiting.pop()) {
    if (!/\.(html|js|mjs|css)$/.test(path)) continue;
    const text = readFileSync(join(site, path), "utf8");
    for (const other of there) {
      if (needed.has(other) || !text.includes(posix.basename(other))) continue;
      needed.add(other);
      waiting.push(other);
    }
  }
  return [...needed].sort();
}

/**
 * A page as it is in the platform's frame: without the site's header and footer, with the script
 * that talks with the platform before all others, and without links to what is not there.
 * @param {string} html
 * @param {string} path
 * @param {readonly string[]} pages
 */
function framed(html, path, pages) {
  const up = "../".repeat(path.split("/").length - 1);
  /** @param {string} href */
  const isThere = (href) => {
    if (/^(#|[a-z]+:)/i.test(href)) return true;
    const target = posix.join(posix.dirname(path), href.replace(/[?#].*$/, ""));
    return pages.includes(target.endsWith(".html") ? target : posix.join(target, "index.html"));
  };
  return html
    .replace(/\s*<link rel="manifest"[^>]*>/, "")
    .replace(/<html\b/, '<html data-embed=""')
    .replace(/<head>/, `<head>\n    <script src="${up}${ADAPTER}"></script>`)
    .replace(
      /<a\b([^>]*?)\shref="([^"]*)"([^>]*)>([\s\S]*?)<\/a>/g,
      (whole, before, href, after, text) =>
        isThere(href) ? whole : `<span${before}${after}>${text}</span>`,
    );
}

/** @param {string} html */
function titleOf(html) {
  return /<title>([^<]*)<\/title>/.exec(html)?.[1] ?? "";
}

/**
 * @param {string} slug
 * @param {string} title as it stands in the page: escaped
 * @param {string} page
 * @param {readonly string[]} paths
 */
function manifest(slug, title, page, paths) {
  const files = paths.map((path) => `      <file href="${escaped(path)}"/>`).join("\n");
  return `<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="bugbot-${slug}" version="1.0"
    xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
    xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2"
    xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
    xsi:schemaLocation="http://www.imsproject.org/xsd/imscp_rootv1p1p2 imscp_rootv1p1p2.xsd
                        http://www.adlnet.org/xsd/adlcp_rootv1p2 adlcp_rootv1p2.xsd">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="lesson">
    <organization identifier="lesson">
      <title>${title}</title>
      <item identifier="page" identifierref="files" isvisible="true">
        <title>${title}</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="files" type="webcontent" adlcp:scormtype="sco" href="${page}">
${files}
    </resource>
  </resources>
</manifest>
`;
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
}

async function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { site: { type: "string" }, out: { type: "string" } },
  });
  const [slug] = positionals;
  if (!slug) fail("Which lesson?", "npm run lesson:scorm -- u8-1-a-map-of-cells");
  ensureInstalled();
  if (!values.site) {
    const { build } = await import("./build.mjs");
    await build();
  }
  const { zip } = await import("./zip.mjs");
  const files = await scormFiles(slug, resolve(values.site ?? join(ROOT, "dist")));
  const out = values.out ?? join(ROOT, `${slug}-scorm12.zip`);
  const archive = zip(files);
  writeFileSync(out, archive);
  console.log(`${out}: ${files.length} files, ${(archive.length / 1e6).toFixed(1)} MB`);
}

if (process.argv[1] === import.meta.filename) {
  try {
    await main();
  } catch (error) {
    fail(messageOf(error));
  }
}
