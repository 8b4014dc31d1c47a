/** The page for whoever writes a lesson, in the development server: what learners will be told. */
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { createServer, type ViteDevServer } from "vite";
import { filesBelow, ROOT } from "../../site/build/files.mjs";
import { bugbot } from "../../site/build/plugin.mjs";

/** A course of one lesson, which the story may change. */
let course: string;
let server: ViteDevServer;
let address: string;

test.beforeAll(async () => {
  course = mkdtempSync(join(tmpdir(), "course-"));
  cpSync(join(ROOT, "tests/lessons/tiny-course"), course, { recursive: true });
  server = await createServer({
    configFile: false,
    root: join(ROOT, "site"),
    cacheDir: join(course, ".vite"),
    appType: "mpa",
    logLevel: "error",
    plugins: [bugbot({ lessons: course })],
    server: { host: "127.0.0.1", port: 0 },
  });
  await server.listen();
  address = server.resolvedUrls?.local[0] ?? "";
});

test.afterAll(async () => {
  await server.close();
  rmSync(course, { recursive: true });
});

test("an author sees what each program earns, and what no wrong attempt shows @once", async ({
  page,
}) => {
  test.slow();
  const attempt = join(course, "one-step/whole-steps/wrong/rounded-up.py");
  const nearest = join(course, "one-step/whole-steps/wrong/rounded.py");
  writeFileSync(
    attempt,
    readFileSync(attempt, "utf8").replace("# earns: rounded up", "# earns: x"),
  );
  rmSync(nearest);
  rmSync(join(course, "one-step/whole-steps/equivalent.json"));
  await page.goto(`${address}preview/one-step/`);
  const task = page.getByRole("region", { name: "Whole steps" });
  const row = (file: string) => task.getByRole("group").filter({ hasText: file });
  await expect(row("wrong/rounded-up.py")).toContainText("Not marked yet");

  // One task is marked, the other is left alone.
  await task.getByRole("button", { name: "Mark this task" }).click();
  await expect(row("starter.py")).toContainText("Fails, as it should");
  await expect(row("solution.py")).toContainText("Passes");
  await expect(row("wrong/one-too-many.py")).toContainText("Earns its words");
  await expect(row("wrong/rounded-up.py")).toContainText("Earns other words");
  const overview = page.getByRole("row", { name: /^Whole steps/ });
  await expect(overview).toContainText("2 of 3");
  await expect(page.getByRole("row", { name: /^A step up/ })).toContainText("not marked");

  // A wrong attempt: the program, what a learner reads, and what it should have earned.
  await row("wrong/rounded-up.py").locator("summary").click();
  const open = row("wrong/rounded-up.py");
  await expect(open.getByRole("region", { name: "Program" })).toContainText("ceil(length / step)");
  const read = open.getByRole("region", { name: "What the learner reads" });
  await expect(read).toContainText("Not yet: 1 of 4 checks pass");
  await expect(read).toContainText("Expected");
  await expect(read).toContainText("steps(12, 5) gives 2");
  await expect(read).toContainText("rounded up: a step that is only begun is no whole step");
  await expect(read.getByRole("region", { name: "The check points at hint 2" })).toHaveText(
    /Hint 2 of 3\s*Divide\./,
  );
  await expect(read).toContainText("Should earn");

  // Causes, and the one that no file earns.
  const causes = task.getByRole("region", { name: "Causes" }).getByRole("listitem");
  await expect(causes.filter({ hasText: "to the nearest" })).toContainText(
    "not held by a wrong attempt",
  );
  await task.getByText("3 causes held by wrong attempts").click();
  await expect(causes.filter({ hasText: "rounded up:" })).toContainText("rounded-up.py");

  // The small changes of the solution, and the one that still passes.
  const mutants = task.getByRole("region", { name: "Mutants" });
  await mutants.getByRole("button", { name: "Try the mutants" }).click();
  const still = mutants.getByRole("list", { name: "Open mutants" }).getByRole("listitem");
  await expect(still).toHaveCount(1, { timeout: 60_000 });
  await expect(still.getByRole("deletion")).toContainText("return int(length // step)");
  await expect(still.getByRole("insertion")).toContainText("return int(length / step)");
  await expect(overview).toContainText("1 open");

  // A file is saved: the page comes again as it was, and that file alone is marked again.
  writeFileSync(
    attempt,
    readFileSync(attempt, "utf8").replace("# earns: x", "# earns: rounded up"),
  );
  await expect(row("wrong/rounded-up.py")).toContainText("Earns its words");
  await expect(read).toContainText("Not yet: 1 of 4 checks pass");
});

test("the published site has nothing of the authors' page @once", () => {
  const dist = join(ROOT, "dist");
  const texts = filesBelow(dist, (path: string) => /\.(js|css|html|json)$/.test(path));
  expect(texts.length).toBeGreaterThan(50);
  const ours =
    /What learners are told|What the learner reads|preview-data|preview-task|\/preview\//;
  const found = texts.filter((path) => ours.test(readFileSync(join(dist, path), "utf8")));
  expect(found).toEqual([]);
});
