/**
 * The files of the site on this device: fetched, checked, given out, tidied. The service worker is
 * its only user; caches and network are handed in, so that it can be tried without either.
 *
 * A page is never worse off with it than without: what is not kept, or is not as it was published,
 * comes over the network, and a device without room for a file gets it all the same.
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
  /** SHA-256 of some bytes, in base64. */
  hash(bytes: ArrayBuffer): Promise<string>;
}

/** So many files are fetched side by side: as many as a browser asks one host for at once. */
const SIDE_BY_SIDE = 6;

export class Shelf {
  readonly #scope: string;
  readonly #site: SiteFiles;
  readonly #tools: ShelfTools;
  /** What was kept has been taken away at the reader's wish: nothing is to come back. */
  #removed = false;
  /** What is being put on the shelf at the moment. */
  readonly #puts = new Set<Promise<void>>();
  /** Answers from the network that are to be kept, and are still on their way. */
  readonly #behind = new Set<Promise<void>>();

  /** @param scope the address of the site's folder */
  constructor(scope: string, site: SiteFiles, tools: ShelfTools) {
    this.#scope = scope;
    this.#site = site;
    this.#tools = tools;
  }

  /**
   * Puts this version's pages and scripts on the shelf, and whatever of Python the version before
   * it has there: a new version is worth offering when it can do what the old one can. Where the
   * device has no room for them, the version does without: its pages come over the network, and
   * nobody has to stay with an old version for that.
   * Throws an Error that names the file if one can't be had as it was published.
   */
  async install(): Promise<void> {
    try {
      await this.#fill();
    } catch (error) {
      if (!isNoRoom(error)) throw error;
      await this.#tools.caches.delete(versionCache(this.#scope, this.#site.version));
    }
  }

  async #fill(): Promise<void> {
    const kept = await this.#kept();
    const before = await this.#versionsBefore();
    const had = (part: Part): boolean =>
      before.some(({ files }) =>
        Object.keys(files).every((path) => partOf(path) !== part || kept.has(path)),
      );
    await this.keep(["site", ...(["python", "numpy"] as const).filter(had)]);
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
        if (this.#removed) throw new Error("what was kept is being removed");
        await this.#fetch(path);
      }
    };
    await Promise.all(Array.from({ length: SIDE_BY_SIDE }, next));
    // Comes last: a version with its list is complete.
    if (parts.includes("site")) await this.#put(LIST, new Response(JSON.stringify(this.#site)));
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
   * file of the site. Rejects as `fetch` does. A request past all caches (`reload`) doubts what is
   * kept, so the network comes first.
   */
  async answer(request: Request): Promise<Response> {
    const path = pathAt(this.#scope, request.url) ?? "";
    if (this.#isFolder(path)) return Response.redirect(`${addressOf(this.#scope, path)}/`, 301);
    const { cache } = request;
    if (cache !== "reload") {
      const kept = await this.#asPublished(path);
      if (kept) return kept;
    }
    let response: Response;
    try {
      // A damaged file may be in the browser's own cache as well.
      const options = cache === "reload" ? { cache } : {};
      response = await this.#tools.fetch(request.url, { ...options, credentials: "same-origin" });
    } catch (error) {
      const kept = cache === "reload" ? await this.#asPublished(path) : null;
      if (kept) return kept;
      throw error;
    }
    if (response.ok && path in this.#site.files && isLasting(path)) {
      // Nobody waits for this, and if it fails the page has its file all the same.
      const keeping = this.#keepAnswer(path, response.clone()).catch(() => {});
      this.#behind.add(keeping);
      void keeping.then(() => this.#behind.delete(keeping));
    }
    return response;
  }

  /** Resolves when what has been answered is kept as well. */
  async settled(): Promise<void> {
    while (this.#behind.size > 0) await Promise.all(this.#behind);
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
    await Promise.allSettled(this.#puts);
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
    const putting = this.#cacheOf(path).then((cache) => cache.put(this.#address(path), response));
    this.#puts.add(putting);
    try {
      await putting;
    } finally {
      this.#puts.delete(putting);
    }
  }

  async #keepAnswer(path: string, response: Response): Promise<void> {
    const bytes = await response.arrayBuffer();
    if (await this.#isRight(path, bytes)) await this.#put(path, withBody(response, bytes));
  }

  /** What is kept of a file, if it is what was published; what is not is thrown away. */
  async #asPublished(path: string): Promise<Response | null> {
    const kept = await this.#find(path);
    if (!kept || isCheckedByPage(path)) return kept ?? null;
    const bytes = await kept.arrayBuffer();
    if (await this.#isRight(path, bytes)) return withBody(kept, bytes);
    await (await this.#cacheOf(path)).delete(this.#address(path));
    return null;
  }

  /** A page of an older version may ask for a script of its own that lasts: of it nothing is known. */
  async #isRight(path: string, bytes: ArrayBuffer): Promise<boolean> {
    const expected = this.#site.files[path]?.sha256;
    return expected === undefined || (await this.#tools.hash(bytes)) === expected;
  }

  async #find(path: string): Promise<Response | undefined> {
    if (this.#removed) return undefined;
    const cache = await this.#cacheOf(path);
    // Without all of them, a version's pages are left to the network, which may have newer ones.
    if (!isLasting(path) && !(await cache.match(this.#address(LIST)))) return undefined;
    return cache.match(this.#address(path));
  }

  #cacheOf(path: string): Promise<Cache> {
    return isLasting(path) ? this.#lasting() : this.#ownCache();
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
      const site = await list?.json().catch(() => null);
      if (isSite(site)) lists.push(site);
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

/** The browser's own word for a device, or a site's share of it, that is full. */
export function isNoRoom(error: unknown): boolean {
  return error instanceof Error && error.name === "QuotaExceededError";
}

/**
 * Packed files with a checksum in them, which the page unpacks: it asks again, with `reload`, if one is
 * damaged. They are most of what is kept, and checking them here would hold up Python's start.
 */
function isCheckedByPage(path: string): boolean {
  return /^python\/(interpreter|snapshot|sources)-/.test(path);
}

/** The same answer with its body read. */
function withBody({ status, headers }: Response, body: ArrayBuffer): Response {
  const kept = new Headers(headers);
  // They tell how it came over the network.
  for (const name of ["Content-Encoding", "Content-Length"]) kept.delete(name);
  return new Response(body, { status, headers: kept });
}

function isSite(value: unknown): value is SiteFiles {
  return typeof value === "object" && value !== null && "files" in value && !!value.files;
}
