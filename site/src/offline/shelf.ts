/**
 * The files of the site on this device: fetched, checked, given out, tidied. The service worker is
 * its only user; caches and network are handed in, so that it can be tried without either.
 * Imports nothing but this room.
 */
import type { Kept } from "./messages.ts";
import {
  addressOf,
  cachePrefix,
  isLasting,
  LIST,
  lastingCache,
  type Part,
  partOf,
  pathAt,
  type SiteFiles,
  versionCache,
} from "./site-files.ts";

export interface ShelfTools {
  caches: CacheStorage;
  fetch(address: string, options: RequestInit): Promise<Response>;
}

/** So many files are fetched side by side: as many as a browser asks one host for at once. */
const SIDE_BY_SIDE = 6;

export class Shelf {
  readonly #scope: string;
  readonly #site: SiteFiles;
  readonly #tools: ShelfTools;
  /** What was kept has been taken away at the reader's wish: nothing is to come back. */
  #removed = false;

  /** @param scope the address of the site's folder */
  constructor(scope: string, site: SiteFiles, tools: ShelfTools) {
    this.#scope = scope;
    this.#site = site;
    this.#tools = tools;
  }

  /**
   * Puts this version's pages and scripts on the shelf, and whatever of Python the version before
   * it has there: a new version is worth offering when it can do what the old one can.
   * Throws an Error that names the file if one can't be had as it was published.
   */
  async install(): Promise<void> {
    const kept = await this.#kept();
    const before = await this.#versionsBefore();
    const had = (part: Part): boolean =>
      before.some(({ files }) =>
        Object.keys(files).every((path) => partOf(path) !== part || kept.has(path)),
      );
    await this.keep(["site", ...(["python", "numpy"] as const).filter(had)]);
    const cache = await this.#ownCache();
    // Comes last: a version with its list is complete.
    await cache.put(this.#address(LIST), new Response(JSON.stringify(this.#site)));
  }

  /** Fetches what is missing of some parts, and of files by their addresses. */
  async keep(parts: readonly Part[], used: readonly string[] = []): Promise<void> {
    const kept = await this.#kept();
    const paths = new Set(used.map((address) => pathAt(this.#scope, address)));
    const missing = Object.keys(this.#site.files).filter(
      (path) => !kept.has(path) && (parts.includes(partOf(path)) || paths.has(path)),
    );
    const next = async (): Promise<void> => {
      for (let path = missing.shift(); path !== undefined; path = missing.shift()) {
        await this.#fetch(path);
      }
    };
    await Promise.all(Array.from({ length: SIDE_BY_SIDE }, next));
  }

  /** How much of each part is here. */
  async status(): Promise<Record<Part, Kept>> {
    const kept = await this.#kept();
    const none = (): Kept => ({ have: 0, of: 0 });
    const parts: Record<Part, Kept> = { site: none(), python: none(), numpy: none() };
    for (const [path, { bytes }] of Object.entries(this.#site.files)) {
      const part = parts[partOf(path)];
      part.of += bytes;
      if (kept.has(path)) part.have += bytes;
    }
    return parts;
  }

  /** Whether requests for this address are answered here; others are the browser's. */
  answers(address: string): boolean {
    const path = pathAt(this.#scope, address);
    return path !== null && (path in this.#site.files || isLasting(path) || this.#isFolder(path));
  }

  /**
   * The answer to a request: what is kept, and else what the network has, which is kept if it is a
   * file of the site. Rejects as `fetch` does.
   */
  async answer(request: Request): Promise<Response> {
    const path = pathAt(this.#scope, request.url) ?? "";
    if (this.#isFolder(path)) return Response.redirect(`${addressOf(this.#scope, path)}/`, 301);
    // A page of an older version may ask for a script of its own that lasts.
    const kept = await this.#find(path);
    if (kept) return kept;
    const response = await this.#tools.fetch(request.url, { credentials: "same-origin" });
    if (response.ok && path in this.#site.files && isLasting(path)) {
      await this.#put(path, response.clone());
    }
    return response;
  }

  /** Takes away what only other versions have. No page of theirs may be open, nor one wait. */
  async tidy(): Promise<void> {
    const { caches } = this.#tools;
    const own = versionCache(this.#scope, this.#site.version);
    for (const name of await this.#names()) {
      if (name.startsWith(versionCache(this.#scope, "")) && name !== own) await caches.delete(name);
    }
    const lasting = await this.#lasting();
    for (const { url } of await lasting.keys()) {
      const path = pathAt(this.#scope, url);
      if (path === null || !(path in this.#site.files)) await lasting.delete(url);
    }
  }

  /** Takes everything away. */
  async remove(): Promise<void> {
    this.#removed = true;
    for (const name of await this.#names()) await this.#tools.caches.delete(name);
  }

  // -- one file ------------------------------------------------------------------

  /** A file in the form that hashes to what the list says, or an Error that says what is wrong. */
  async #fetch(path: string): Promise<void> {
    const address = this.#address(path);
    const lasting = isLasting(path);
    const integrity = `sha256-${this.#site.files[path]?.sha256}`;
    const get = (cache: RequestCache): Promise<Response> =>
      this.#tools.fetch(address, { cache, integrity, credentials: "same-origin" });
    let response: Response;
    try {
      // What the page has just had need not come over the network a second time.
      response = await get(lasting ? "force-cache" : "no-cache");
    } catch {
      try {
        response = await get("reload");
      } catch {
        throw new Error(`${path} can't be had, or is not as it was published`);
      }
    }
    if (!response.ok) throw new Error(`${path} can't be had: status ${response.status}`);
    await this.#put(path, response);
  }

  async #put(path: string, response: Response): Promise<void> {
    if (this.#removed) return;
    const cache = isLasting(path) ? await this.#lasting() : await this.#ownCache();
    await cache.put(this.#address(path), response);
  }

  async #find(path: string): Promise<Response | undefined> {
    if (this.#removed) return undefined;
    const cache = isLasting(path) ? await this.#lasting() : await this.#ownCache();
    return cache.match(this.#address(path));
  }

  /** The paths of all files that are here, of other versions too if they last. */
  async #kept(): Promise<Set<string | null>> {
    const caches = this.#removed ? [] : [await this.#lasting(), await this.#ownCache()];
    const requests = await Promise.all(caches.map((cache) => cache.keys()));
    return new Set(requests.flat().map(({ url }) => pathAt(this.#scope, url)));
  }

  /** `lab` for the folder `lab/`. */
  #isFolder(path: string): boolean {
    return !(path in this.#site.files) && `${path}/index.html` in this.#site.files;
  }

  // -- versions --------------------------------------------------------------------

  /** The lists of the other versions that are complete. */
  async #versionsBefore(): Promise<SiteFiles[]> {
    const lists = [];
    for (const name of await this.#names()) {
      const prefix = versionCache(this.#scope, "");
      if (!name.startsWith(prefix) || name === prefix + this.#site.version) continue;
      const list = await (await this.#tools.caches.open(name)).match(this.#address(LIST));
      if (list) lists.push((await list.json()) as SiteFiles);
    }
    return lists;
  }

  async #names(): Promise<string[]> {
    const prefix = cachePrefix(this.#scope);
    return (await this.#tools.caches.keys()).filter((name) => name.startsWith(prefix));
  }

  #lasting(): Promise<Cache> {
    return this.#tools.caches.open(lastingCache(this.#scope));
  }

  #ownCache(): Promise<Cache> {
    return this.#tools.caches.open(versionCache(this.#scope, this.#site.version));
  }

  #address(path: string): string {
    return addressOf(this.#scope, path);
  }
}
