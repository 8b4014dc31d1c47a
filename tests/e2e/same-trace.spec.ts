/**
 * The same program, world and seed leave the same trace in the browser and under plain CPython,
 * event for event, for every demo of the article and every ready program of the lab: for some of them in
 * `npm test`, for all in `npm run test:long`.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { filesBelow, ROOT } from "../../site/build/files.mjs";
import { nativeTrace, partingOf } from "../native-trace.mjs";
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

// Demo 1 has its figures held against the prose with all its experiments (article.spec.ts).
const SAMPLE = [...demos.slice(1), ...ready.slice(0, 1)];

for (const { which, tag, cases, least } of [
  { which: "the demos and a ready program", tag: [], cases: SAMPLE, least: 4 },
  { which: "all there are", tag: ["@long"], cases: [...demos, ...ready], least: 10 },
]) {
  test(`native and browser traces are equal: ${which}`, { tag }, async ({ app, page }) => {
    test.slow();
    expect(cases.length).toBeGreaterThanOrEqual(least);
    await app.openLab();
    for (const one of cases) {
      await test.step(`${one.file.slice(ROOT.length)} on ${one.world}`, async () => {
        const browser = await page.locator("bugbot-lab").evaluate(
          async (lab: HTMLElement & Lab, { world, seed, program }) => {
            // Each world has a program of its own, which this one takes the place of.
            Object.assign(lab, { world, seed, program });
            await lab.run();
            return lab.traceText();
          },
          { ...one, program: readFileSync(one.file, "utf8") },
        );
        expect(partingOf(browser ?? "", nativeTrace(one))).toBe("");
      });
    }
  });
}

interface Lab {
  world: string;
  seed: number;
  program: string;
  run(): Promise<unknown>;
  traceText(): Promise<string | null>;
}
