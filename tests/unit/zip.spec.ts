/** The archives that `npm run pack` writes, read by somebody else's reader. */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { findPython } from "../../site/build/tools.mjs";
import { zip } from "../../site/build/zip.mjs";

test("what is packed comes out again, whatever its name and content", () => {
  const folder = mkdtempSync(join(tmpdir(), "zip-"));
  const files = [
    { path: "READ-ME.txt", data: Buffer.from("read me\r\n".repeat(500)) },
    { path: "a folder/Grüße.bin", data: Buffer.from([0, 255, 7]) },
    { path: "empty", data: Buffer.alloc(0) },
  ];
  writeFileSync(join(folder, "x.zip"), zip(files));
  // Python's reader checks each file's sum.
  const done = spawnSync(findPython(), ["-m", "zipfile", "-e", "x.zip", "."], { cwd: folder });
  expect(done.stderr.toString()).toBe("");
  for (const { path, data } of files) expect(readFileSync(join(folder, path))).toEqual(data);
  expect(zip(files)).toEqual(zip(files));
  rmSync(folder, { recursive: true });
});

test("no file may lead out of the folder it is unpacked in", () => {
  for (const path of ["/etc/passwd", "../up", "a/../../up"]) {
    expect(() => zip([{ path, data: Buffer.alloc(1) }])).toThrow("outside its folder");
  }
});
