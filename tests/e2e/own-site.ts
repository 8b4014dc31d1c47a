/**
 * For stories that cut the network or publish a new version: a copy of the built site with a server
 * of its own, which such a story may stop or change without others noticing.
 */
import { type ChildProcess, spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";
import { test as base } from "./fixtures.ts";

/** The built site; elsewhere than usual if DIST says so. */
export const DIST = process.env.DIST ?? join(ROOT, "dist");

export class OwnSite {
  readonly folder: string;
  url = "";
  #server: ChildProcess | null = null;

  constructor(folder: string) {
    this.folder = folder;
  }

  async serve(): Promise<void> {
    const script = join(ROOT, "tests/static-server.mjs");
    this.#server = spawn("node", [script, "0", "/some/school/", this.folder]);
    this.url = await firstLine(this.#server);
  }

  /** From now on there is no network. */
  async cut(): Promise<void> {
    const server = this.#server;
    this.#server = null;
    if (!server) return;
    const gone = new Promise((resolve) => server.once("exit", resolve));
    server.kill();
    await gone;
  }

  /** Puts a new version in place of the one that is served, as an upload does. */
  publish(files: Readonly<Record<string, string>>): void {
    let worker = readFileSync(join(this.folder, "sw.js"), "utf8");
    for (const [path, text] of Object.entries(files)) {
      const before = listed(readFileSync(join(this.folder, path)));
      writeFileSync(join(this.folder, path), text);
      worker = worker.replace(before, listed(Buffer.from(text)));
    }
    worker = worker.replace(/"version":"\w+"/, '"version":"afteranother"');
    writeFileSync(join(this.folder, "sw.js"), worker);
  }
}

/** How the service worker's list tells of a file. */
function listed(data: Buffer): string {
  const sha256 = createHash("sha256").update(data).digest("base64");
  return JSON.stringify({ bytes: data.length, sha256 });
}

export function firstLine({ stdout }: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    stdout?.once("data", (data: Buffer) => resolve(data.toString().trim()));
    stdout?.once("close", () => reject(new Error("the server has ended without a word")));
  });
}

export const test = base.extend<{ site: OwnSite }>({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright asks for the braces
  site: async ({}, use) => {
    const folder = mkdtempSync(join(tmpdir(), "own-site-"));
    cpSync(DIST, folder, { recursive: true });
    const site = new OwnSite(folder);
    await site.serve();
    await use(site);
    await site.cut();
    rmSync(folder, { recursive: true, force: true });
  },

  baseURL: async ({ site }, use) => use(site.url),

  serviceWorkers: "allow",
});
