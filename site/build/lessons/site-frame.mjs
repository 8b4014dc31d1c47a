/**
 * What all pages share around their content: the header, the footer, and what is said in the head.
 * Pages hold the comments `<!-- header -->` and `<!-- footer -->` in their place.
 */
import { existsSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../files.mjs";
import { escapeHtml } from "./html.mjs";

const SITE_NAME = "bugbot lessons";

/** The pages of the header; those that are not there (yet) are left out. */
const PLACES = [
  {
    path: "occupancy-grid-mapping/",
    text: "Article",
    there: "lessons/occupancy-grid-mapping/lesson.md",
  },
  { path: "#lessons-title", text: "Lessons", there: "site/index.html" },
  { path: "lab/", text: "Lab", there: "site/lab/index.html" },
  { path: "api/", text: "Calls", there: "site/api/index.html" },
];

/**
 * The site's own address with a slash at its end, from SITE_URL; null where it is not known. Only
 * what other sites read (canonical addresses, the map of the site) needs it.
 * @returns {string | null}
 */
export function siteAddress() {
  const text = process.env.SITE_URL;
  if (!text) return null;
  try {
    const url = new URL(text);
    return url.href.endsWith("/") ? url.href : `${url.href}/`;
  } catch {
    throw new Error(
      `SITE_URL is "${text}", which is no address.\nRemedy: SITE_URL=https://example.org/lessons/ npm run build`,
    );
  }
}

/**
 * The way from a page to the site's own folder: "lessons/x/" -> "../../".
 * @param {string} path
 */
export function toRoot(path) {
  return "../".repeat(path.split("/").length - 1) || "./";
}

/**
 * @param {{ path: string, title: string, description: string, article: boolean }} page
 */
export function headTags({ path, title, description, article }) {
  const address = siteAddress();
  const words = escapeHtml(description);
  const whole = escapeHtml(path === "" ? title : `${title} · ${SITE_NAME}`);
  const tags = [
    `<title>${whole}</title>`,
    `<meta name="description" content="${words}" />`,
    `<meta property="og:title" content="${escapeHtml(title)}" />`,
    `<meta property="og:description" content="${words}" />`,
    `<meta property="og:type" content="${article ? "article" : "website"}" />`,
    `<meta property="og:site_name" content="${SITE_NAME}" />`,
  ];
  if (address) {
    tags.push(
      `<link rel="canonical" href="${address}${path}" />`,
      `<meta property="og:url" content="${address}${path}" />`,
      `<meta property="og:image" content="${address}map.png" />`,
      `<meta property="og:image:alt" content="A map that a small robot made: free cells, occupied cells, and what it never saw" />`,
    );
  }
  return tags.join("\n    ");
}

/**
 * Puts header and footer in the place of their comments.
 * @param {string} html
 * @param {string} path of the page
 */
export function withFrame(html, path) {
  return html
    .replace("<!-- header -->", headerHtml(path))
    .replace("<!-- footer -->", footerHtml(path));
}

/** @param {string} path */
function headerHtml(path) {
  const root = toRoot(path);
  const links = PLACES.filter(({ there }) => existsSync(join(ROOT, there))).map((place) => {
    const current = place.path === path ? ' aria-current="page"' : "";
    return `<a href="${root}${place.path}"${current}>${place.text}</a>`;
  });
  return `<header class="site-header">
      <a class="name" href="${root}"${path === "" ? ' aria-current="page"' : ""}>
        <img src="/favicon.svg" alt="" width="24" height="24" />${SITE_NAME}
      </a>
      <nav aria-label="Site">${links.join("\n        ")}</nav>
      <div class="theme-switch"></div>
    </header>`;
}

/** @param {string} path */
function footerHtml(path) {
  return `<footer class="site-footer">
      <p>
        Your programs and your progress are kept on this device only. Free to use and to change under
        the <a href="${toRoot(path)}licences.txt">MIT licence</a>.
      </p>
      <div class="offline"></div>
    </footer>`;
}

/**
 * The map of the site for search engines, or null where the site's address is not known.
 * @param {readonly string[]} paths
 */
export function siteMap(paths) {
  const address = siteAddress();
  if (!address) return null;
  const urls = paths.map((path) => `  <url><loc>${escapeHtml(address + path)}</loc></url>`);
  return `<?xml version="1.0" encoding="UTF-8"?>
<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">
${urls.join("\n")}
</urlset>
`;
}
