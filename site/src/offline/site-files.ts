/**
 * What a version of the site consists of, as the build lists it, and where its files are kept.
 * Pure; imports nothing of ours.
 *
 * Files below `assets/` and `python/` carry a hash of their content in their name: an address means
 * the same bytes for ever, so all versions share one cache of them. The others (pages, icons) have
 * the same address in every version, so each version has a cache of its own for them.
 */

/** Path from the site's folder -> its size [bytes] and what it must hash to. */
export type FileList = Readonly<Record<string, { bytes: number; sha256: string }>>;

export interface SiteFiles {
  /** Another as soon as any file is another. */
  version: string;
  files: FileList;
}

/**
 * What is kept together: the site's own pages and scripts; what any program needs; what only
 * programs with `import numpy` need.
 */
export type Part = "site" | "python" | "numpy";

export function partOf(path: string): Part {
  if (path.startsWith("python/numpy-")) return "numpy";
  return path.startsWith("python/") ? "python" : "site";
}

/** Whether the file's address always means the same bytes. */
export function isLasting(path: string): boolean {
  return path.startsWith("assets/") || path.startsWith("python/");
}

/** Whom all of the caches below belong to: an origin may hold several copies of the site. */
export function cachePrefix(scope: string): string {
  return `bugbot:${new URL(scope).pathname}:`;
}

/** The cache of the files whose addresses last, of all versions. */
export function lastingCache(scope: string): string {
  return `${cachePrefix(scope)}lasting`;
}

/** The cache of a version's other files, and of its list. */
export function versionCache(scope: string, version: string): string {
  return `${cachePrefix(scope)}version:${version}`;
}

/** The problem of a device that gives the site too little room, among those in words. */
export const NO_ROOM = "no room";

/** Where a version's cache holds its list. No file of the site has this name. */
export const LIST = "files-of-this-version.json";

/**
 * The address of a file. A folder's page is asked for by the folder: some hosts redirect the name
 * `index.html`, and a browser takes no redirected answer for a page.
 */
export function addressOf(scope: string, path: string): string {
  return new URL(path.replace(/(^|\/)index\.html$/, "$1"), scope).href;
}

/** The path below the site's folder that an address means; null for addresses elsewhere. */
export function pathAt(scope: string, address: string): string | null {
  const { origin, pathname } = new URL(address);
  const site = new URL(scope);
  if (origin !== site.origin || !pathname.startsWith(site.pathname)) return null;
  const path = pathname.slice(site.pathname.length);
  return path === "" || path.endsWith("/") ? `${path}index.html` : path;
}
