/** A project's results: every run with its map, figures against limits, a score to improve. */
import AxeBuilder from "@axe-core/playwright";
import { expect, test } from "./fixtures.ts";
import { mapper, PROJECT } from "./project.ts";
import { readRosMap } from "./ros-reader.ts";
import { Task } from "./task-page.ts";
import { openTinyLesson } from "./tiny-lesson.ts";

test.slow();

test("each run of a project is shown beside the truth, and the best score stays", {
  tag: "@once",
}, async ({ page }) => {
  await openTinyLesson(page, PROJECT);
  const task = new Task(page, "The cell of a point");
  await task.marked(mapper(13));
  await expect(task.mark).toContainText("Not yet: 0 of 2 checks pass.");
  const card = task.root.getByRole("region", { name: "Results", exact: true });
  await expect(card).toContainText("Your first score");
  await expect(card).toContainText("0 of 3 runs keep to the limits.");
  const score = Number(/Score ([\d.]+) of 100/.exec((await task.mark.textContent()) ?? "")?.[1]);
  expect(score).toBeGreaterThan(60);

  const pillar = card.getByRole("region", { name: "Mat “A pillar”", exact: true });
  await expect(
    pillar.getByRole("img", { name: "The mat “A pillar” as it really is" }),
  ).toBeVisible();
  await expect(
    pillar.getByRole("img", { name: /Your map with seed [12]: \d+ % free, \d+ % occupied/ }),
  ).toHaveCount(2);
  const table = pillar.getByRole("table", { name: "Figures of the runs on “A pillar”" });
  await expect(table.getByRole("columnheader")).toHaveText(["Figure", "Limit", "Seed 1", "Seed 2"]);
  const row = (name: RegExp) => table.getByRole("row", { name });
  await expect(row(/^time/).getByRole("cell")).toHaveText([
    "at most 11 s",
    /13\.0 s\s*, outside the limit/,
    /13\.0 s\s*, outside the limit/,
  ]);
  await expect(
    row(/^known/)
      .getByRole("cell")
      .first(),
  ).toHaveText("at least 30 %");
  await expect(pillar).toContainText("all round");

  await task.marked(mapper(10));
  await expect(task.mark).toContainText("Passed. All 2 checks pass. Score");
  await expect(card).toContainText("All 3 runs keep to the limits.");
  await expect(card).toContainText(`Your best is ${score.toFixed(1)}`);
  await expect(row(/^time/).getByRole("cell").nth(1)).toHaveText(
    /^\s*10\.0 s\s*−3\.0, 3\.0 s less than last time\s*$/,
  );

  const { violations } = await new AxeBuilder({ page })
    .setLegacyMode()
    .include("results-card")
    .analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([]);

  // The run is shown in the lab; its map is taken away.
  const saving = page.waitForEvent("download");
  await pillar.getByRole("button", { name: "Download as ROS map: “A pillar”, seed 2" }).click();
  const download = await saving;
  expect(download.suggestedFilename()).toBe("a-pillar-seed-2.zip");
  const chunks = (await (await download.createReadStream()).toArray()) as Buffer[];
  const map = readRosMap(Buffer.concat(chunks));
  const known = map.nav2.filter((cell) => cell !== -1).length / 16;
  await expect(
    row(/^known/)
      .getByRole("cell")
      .nth(2),
  ).toContainText(`${known.toFixed(1)} %`);
  await pillar.getByRole("button", { name: "Show this run: “A pillar”, seed 2" }).click();
  await expect(task.runStatus).toContainText("This is the check’s run on “A pillar”, not yours.");

  await page.reload();
  await expect(task.mark).toContainText(`Your best score is ${score.toFixed(1)} of 100.`);
});
