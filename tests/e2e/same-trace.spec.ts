/**
 * The same program, world and seed leave the same trace in the browser and under plain CPython,
 * event for event, for every demo of the article and every ready program of the lab.
 */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { filesBelow, ROOT } from "../../site/build/files.mjs";
import { venvTool } from "../setup.mjs";
import { expect, test } from "./fixtures.ts";

const ARTICLE = join(ROOT, "lessons/occupancy-grid-mapping/programs");
const LAB = join(ROOT, "lessons/lab");
const WORLD_OF_DEMO: Record<string, string> = {
  "demo-1": "post-and-shelf",
  "demo-2": "wall-ahead",
  "demo-3": "post-and-shelf",
  "demo-4": "doorway",
};

interface Case {
  file: string;
  world: string;
  seed: number;
}

const demos: Case[] = filesBelow(ARTICLE).map((name: string) => ({
  file: join(ARTICLE, name),
  world: WORLD_OF_DEMO[name.slice(0, 6)] ?? "",
  seed: 1,
}));
const index = JSON.parse(readFileSync(join(LAB, "lab.json"), "utf8")) as {
  world: string;
  program: string;
}[];
const ready: Case[] = index.map(({ world, program }) => ({
  file: join(LAB, program),
  world,
  seed: 7,
}));

function nativeTrace({ file, world, seed }: Case): string {
  const out = join(mkdtempSync(join(tmpdir(), "trace-")), "native.trace");
  const args = ["-m", "bugbot", "run", file, "--world", world, "--seed", `${seed}`, "--trace", out];
  const env = { ...process.env, PYTHONPATH: join(ROOT, "py") };
  const done = spawnSync(venvTool("python"), args, { env, encoding: "utf8" });
  expect(done.status, done.stderr).toBe(0);
  return readFileSync(out, "utf8");
}

test("native and browser traces are equal", async ({ app, page }) => {
  test.slow();
  const cases = [...demos, ...ready];
  expect(cases.length).toBeGreaterThanOrEqual(10);
  await app.openLab();
  for (const one of cases) {
    await test.step(`${one.file.slice(ROOT.length)} on ${one.world}`, async () => {
      const browser = await page.locator("bugbot-lab").evaluate(
        async (lab: HTMLElement & Lab, { world, seed, program }) => {
          Object.assign(lab, { world, seed, program });
          await lab.run();
          return lab.traceText();
        },
        { ...one, program: readFileSync(one.file, "utf8") },
      );
      const expected = nativeTrace(one).trimEnd().split("\n");
      const got = (browser ?? "").trimEnd().split("\n");
      // The header differs in nothing that matters but the order of its fields.
      expect(JSON.parse(got[0] ?? "")).toEqual(JSON.parse(expected[0] ?? ""));
      expect(got.length).toBe(expected.length);
      const parted = got.findIndex((row, i) => i > 0 && !sameRow(row, expected[i] ?? ""));
      expect(parted === -1 ? "" : `row ${parted}: ${got[parted]} / ${expected[parted]}`).toBe("");
    });
  }
});

interface Lab {
  world: string;
  seed: number;
  program: string;
  run(): Promise<unknown>;
  traceText(): string | null;
}

/** Equal values: 5 and 5.0 are two spellings of one number. */
function sameRow(a: string, b: string): boolean {
  return a === b || JSON.stringify(JSON.parse(a)) === JSON.stringify(JSON.parse(b));
}
