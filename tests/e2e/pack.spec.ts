/** The archive of `npm run pack`: unpacked, and served by what every Python has. */
import { type ChildProcess, spawn, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { packed } from "../../site/build/pack.mjs";
import { findPython } from "../../site/build/tools.mjs";
import { test as base, expect } from "./fixtures.ts";
import { DIST } from "./own-site.ts";

const test = base.extend<{ folder: string }>({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright asks for the braces
  folder: async ({}, use) => {
    const folder = mkdtempSync(join(tmpdir(), "packed-"));
    await use(folder);
    rmSync(folder, { recursive: true, force: true });
  },

  baseURL: async ({ folder }, use) => {
    const python = findPython();
    writeFileSync(join(folder, "site.zip"), packed(DIST));
    const unpacking = spawnSync(python, ["-m", "zipfile", "-e", "site.zip", "."], { cwd: folder });
    expect(unpacking.status, unpacking.stderr.toString()).toBe(0);
    // As the READ-ME says, on any port that is free.
    const options = ["0", "--bind", "127.0.0.1", "--directory", "site"];
    const cwd = join(folder, "bugbot-lessons");
    const server = spawn(python, ["-u", "-m", "http.server", ...options], { cwd });
    await use(await addressIn(server));
    server.kill();
  },
});

/** "Serving HTTP on 127.0.0.1 port 40123 (http://127.0.0.1:40123/) ..." */
async function addressIn({ stdout }: ChildProcess): Promise<string> {
  const line = await new Promise<string>((resolve) => {
    stdout?.once("data", (data: Buffer) => resolve(data.toString()));
  });
  const [, address] = /\((http:[^)]*)\)/.exec(line) ?? [];
  if (!address) throw new Error(`Python's server says "${line}"`);
  return address;
}

test("the archive works from a folder with Python's own web server @once", async ({
  page,
  app,
  folder,
}) => {
  const readMe = readFileSync(join(folder, "bugbot-lessons/READ-ME.txt"), "utf8");
  expect(readMe).toContain("python3 -m http.server 8000 --bind 127.0.0.1 --directory site");
  await page.goto("./");
  await page.getByRole("link", { name: "Open the lab" }).click();
  await app.runToEnd("print('from a stick')\n");
  await expect(app.console).toContainText("from a stick");
});
