/** What the service worker keeps, gives out and clears away, tried without one. */
import { expect, test } from "@playwright/test";
import { Shelf } from "../../site/src/offline/shelf.ts";
import { addressOf, pathAt, type SiteFiles } from "../../site/src/offline/site-files.ts";

const SCOPE = "https://example.org/some/school/";
const OTHERS = "bugbot:/another/school/:lasting";

/** Caches as a browser has them, as far as they are used. */
class FakeCaches {
  readonly stores = new Map<string, Map<string, Response>>([[OTHERS, new Map()]]);
  /** How many more files there is room for. */
  room = Number.POSITIVE_INFINITY;

  async open(name: string): Promise<Cache> {
    const store = this.stores.get(name) ?? new Map<string, Response>();
    this.stores.set(name, store);
    return {
      match: async (address: string) => store.get(address)?.clone(),
      put: async (address: string, response: Response) => {
        if (this.room <= 0) throw new DOMException("Quota exceeded", "QuotaExceededError");
        this.room -= 1;
        store.set(address, response);
      },
      keys: async () => [...store.keys()].map((address) => new Request(address)),
      delete: async (address: string) => store.delete(address),
    } as unknown as Cache;
  }

  async keys(): Promise<string[]> {
    return [...this.stores.keys()];
  }

  async delete(name: string): Promise<boolean> {
    return this.stores.delete(name);
  }
}

/** A site of these files, and a host that has them; `asked` notes what was asked of it, and how. */
function world(caches = new FakeCaches()) {
  const asked: string[] = [];
  const broken = new Set<string>();
  const fetch = async (address: string, { cache, integrity }: RequestInit): Promise<Response> => {
    asked.push(`${cache ?? "plain"} ${address.slice(SCOPE.length)} ${integrity ?? ""}`.trim());
    if (broken.has(address)) throw new TypeError("Failed to fetch");
    return new Response(`what ${address} has`);
  };
  /** The path of the file that these are the bytes of. */
  const hash = async (bytes: ArrayBuffer): Promise<string> => {
    const address = /^what (.*) has$/.exec(new TextDecoder().decode(bytes))?.[1];
    return (address && pathAt(SCOPE, address)) ?? "damaged";
  };
  const shelf = (version: string, paths: readonly string[]): Shelf => {
    const files = Object.fromEntries(paths.map((path) => [path, { bytes: 10, sha256: path }]));
    const site: SiteFiles = { version, files };
    return new Shelf(SCOPE, site, { caches: caches as unknown as CacheStorage, fetch, hash });
  };
  return { caches, asked, broken, shelf };
}

const ONE = [
  "index.html",
  "lab/index.html",
  "assets/a-1.js",
  "python/core-1.bin",
  "python/numpy-1.bin",
];
const TWO = [
  "index.html",
  "lab/index.html",
  "assets/a-2.js",
  "python/core-2.bin",
  "python/numpy-1.bin",
];

test("addresses are those of folders, and only those of the site's own folder", () => {
  expect(addressOf(SCOPE, "lab/index.html")).toBe(`${SCOPE}lab/`);
  expect(addressOf(SCOPE, "index.html")).toBe(SCOPE);
  expect(pathAt(SCOPE, `${SCOPE}lab/?world=empty#code=x`)).toBe("lab/index.html");
  expect(pathAt(SCOPE, SCOPE)).toBe("index.html");
  expect(pathAt(SCOPE, "https://example.org/some/other/")).toBeNull();
  expect(pathAt(SCOPE, "https://elsewhere.org/some/school/")).toBeNull();
});

test("the first version keeps its pages, each as it was published, and Python when asked", async () => {
  const { shelf, asked } = world();
  const first = shelf("one", ONE);
  await first.install();
  // Pages are asked of the host anew; what lasts may come from the browser's own cache.
  expect(asked).toEqual([
    "no-cache  sha256-index.html",
    "no-cache lab/ sha256-lab/index.html",
    "force-cache assets/a-1.js sha256-assets/a-1.js",
  ]);
  expect((await first.status()).python).toEqual({ have: 0, of: 10 });
  await first.keep(["python"], [`${SCOPE}python/numpy-1.bin`, "https://elsewhere.org/x.js"]);
  expect(await first.status()).toEqual({
    site: { have: 30, of: 30 },
    python: { have: 10, of: 10 },
    numpy: { have: 10, of: 10 },
  });
  const count = asked.length;
  await first.keep(["site", "python"]);
  expect(asked.length, "nothing is fetched twice").toBe(count);
});

test("requests are answered from the device, and other sites' are left alone", async () => {
  const { shelf, asked } = world();
  const first = shelf("one", ONE);
  await first.install();
  asked.length = 0;
  const page = await first.answer(new Request(`${SCOPE}lab/?world=empty`));
  expect(await page.text()).toBe(`what ${SCOPE}lab/ has`);
  expect((await first.answer(new Request(`${SCOPE}lab`))).headers.get("Location")).toBe(
    `${SCOPE}lab/`,
  );
  expect(asked).toEqual([]);
  // What is used is kept.
  await first.answer(new Request(`${SCOPE}python/numpy-1.bin`));
  await first.settled();
  await first.answer(new Request(`${SCOPE}python/numpy-1.bin`));
  expect(asked).toEqual(["plain python/numpy-1.bin"]);
  expect(first.answers(`${SCOPE}not-there/`)).toBe(false);
  expect(first.answers("https://example.org/")).toBe(false);
});

test("a new version brings what the old one had, and the old one stays until it is cleared away", async () => {
  const { shelf, asked, caches } = world();
  const first = shelf("one", ONE);
  await first.install();
  await first.keep(["python", "numpy"]);
  asked.length = 0;
  const second = shelf("two", TWO);
  await second.install();
  // Not NumPy: it is the same file.
  expect(asked.map((line) => line.split(" ")[1]).sort()).toEqual(
    ["", "assets/a-2.js", "lab/", "python/core-2.bin"].sort(),
  );
  asked.length = 0;
  // A page of the old version that is still open.
  await second.answer(new Request(`${SCOPE}assets/a-1.js`));
  expect(asked).toEqual([]);
  await second.tidy();
  const lasting = caches.stores.get("bugbot:/some/school/:lasting");
  expect([...(lasting?.keys() ?? [])].map((address) => address.slice(SCOPE.length)).sort()).toEqual(
    TWO.slice(2).sort(),
  );
  expect(await caches.keys()).toEqual([
    OTHERS,
    "bugbot:/some/school/:lasting",
    "bugbot:/some/school/:version:two",
  ]);
});

test("a new version without Python before does not fetch it, and a file that can't be had is named", async () => {
  const { shelf, asked, broken } = world();
  await shelf("one", ONE).install();
  asked.length = 0;
  broken.add(`${SCOPE}assets/a-2.js`);
  await expect(shelf("two", TWO).install()).rejects.toThrow(
    "assets/a-2.js can't be had, or is not as it was published",
  );
  expect(asked.some((line) => line.includes("python/"))).toBe(false);
});

test("what is removed does not come back, and another copy of the site loses nothing", async () => {
  const { shelf, caches } = world();
  const first = shelf("one", ONE);
  await first.install();
  await first.remove();
  await first.answer(new Request(`${SCOPE}python/core-1.bin`));
  await expect(first.keep(["site"])).rejects.toThrow("is being removed");
  expect(await caches.keys()).toEqual([OTHERS]);
});

test("an update that is under way when all is removed leaves nothing behind", async () => {
  const { shelf, caches } = world();
  const first = shelf("one", ONE);
  await first.install();
  const second = shelf("two", TWO);
  const updating = second.install();
  await Promise.all([first.remove(), second.remove()]);
  await expect(updating).rejects.toThrow("is being removed");
  expect(await caches.keys()).toEqual([OTHERS]);
});

const VERSION_ONE = "bugbot:/some/school/:version:one";
const LASTING = "bugbot:/some/school/:lasting";

test("a kept file that is damaged is fetched anew, and kept as it should be", async () => {
  for (const [store, path, address] of [
    [VERSION_ONE, "lab/index.html", `${SCOPE}lab/`],
    [LASTING, "assets/a-1.js", `${SCOPE}assets/a-1.js`],
    [LASTING, "python/numpy-1.bin", `${SCOPE}python/numpy-1.bin`],
  ] as const) {
    for (const damage of ["", "something else"]) {
      const { shelf, caches, asked, broken } = world();
      const first = shelf("one", ONE);
      await first.install();
      await first.keep(["numpy"]);
      caches.stores.get(store)?.set(address, new Response(damage));
      asked.length = 0;
      const answer = await first.answer(new Request(address));
      expect(await answer.text(), path).toBe(`what ${address} has`);
      expect(asked.length, path).toBe(1);
      await first.settled();
      if (!path.endsWith(".html")) {
        expect(await (await first.answer(new Request(address))).text()).toContain("what");
        expect(asked.length, "the second time it is kept").toBe(1);
      }
      // Without a network a damaged file is no file: nothing wrong is given out.
      caches.stores.get(store)?.set(address, new Response(damage));
      broken.add(address);
      await expect(first.answer(new Request(address)), path).rejects.toThrow("Failed to fetch");
    }
  }
});

test("who asks past all caches gets what the network has, and what is kept where there is none", async () => {
  const { shelf, asked, broken } = world();
  const first = shelf("one", ONE);
  await first.install();
  await first.keep(["python"]);
  asked.length = 0;
  const address = `${SCOPE}python/core-1.bin`;
  await first.answer(new Request(address, { cache: "reload" }));
  expect(asked).toEqual(["reload python/core-1.bin"]);
  broken.add(address);
  const kept = await first.answer(new Request(address, { cache: "reload" }));
  expect(await kept.text()).toBe(`what ${address} has`);
});

test("a device without room has every page and file, over the network", async () => {
  for (const room of [0, 1, 2, 3, 4]) {
    const { shelf, caches, asked } = world();
    caches.room = room;
    const first = shelf("one", ONE);
    await first.install();
    if (room < 4) await expect(first.keep(["site", "python"])).rejects.toThrow("Quota");
    asked.length = 0;
    for (const path of ONE) {
      const address = addressOf(SCOPE, path);
      const answer = await first.answer(new Request(address));
      expect(await answer.text(), `${room}: ${path}`).toBe(`what ${address} has`);
    }
    // Pages of a version that is not complete may not mix with those that the server has now.
    if (room < 4) expect(asked).toContain("plain lab/");
  }
});

test("of a version that is not all here no page is given out: the server may have newer ones", async () => {
  const { shelf, caches, asked } = world();
  caches.room = 0;
  const first = shelf("one", ONE);
  await first.install();
  caches.room = 2;
  await expect(first.keep(["site"])).rejects.toThrow("Quota");
  asked.length = 0;
  await first.answer(new Request(SCOPE));
  await first.answer(new Request(`${SCOPE}lab/`));
  expect(asked).toEqual(["plain", "plain lab/"]);
  caches.room = 10;
  await first.keep(["site"]);
  asked.length = 0;
  await first.answer(new Request(`${SCOPE}lab/`));
  expect(asked).toEqual([]);
});

test("a new version that does not fit beside the old one can still be taken", async () => {
  const { shelf, caches } = world();
  await shelf("one", ONE).install();
  caches.room = 1;
  const second = shelf("two", TWO);
  await second.install();
  await second.tidy();
  caches.room = 10;
  await second.keep(["site"]);
  expect((await second.status()).site).toEqual({ have: 30, of: 30 });
  expect(caches.stores.has(VERSION_ONE)).toBe(false);
});

test("a damaged list of another version does not stop an update", async () => {
  const { shelf, caches } = world();
  await shelf("one", ONE).install();
  for (const damage of ["", "[1", "null", '{"files":null}']) {
    caches.stores.get(VERSION_ONE)?.set(`${SCOPE}files-of-this-version.json`, new Response(damage));
    await shelf("two", TWO).install();
  }
});
