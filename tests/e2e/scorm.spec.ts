/**
 * A lesson in a learning platform: the package of `lesson:scorm`, in a frame of a page that has a real
 * SCORM run-time (scorm-again), from its launch to the next visit.
 */
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { expect, test } from "@playwright/test";
import { filesBelow, ROOT, write } from "../../site/build/files.mjs";
import { scormFiles } from "../../site/build/scorm.mjs";
import { zip } from "../../site/build/zip.mjs";
import { DIST, OwnSite } from "./own-site.ts";

const SLUG = "u8-1-a-map-of-cells";
const LESSON = join(ROOT, "lessons", SLUG);
const RUNTIME = join(ROOT, "node_modules/scorm-again/dist/scorm12.min.js");

/** What the platform's page has kept of the learner, as the standard's data model. */
interface Kept {
  suspend_data: string;
  core: { lesson_status: string; score: { raw: string }; total_time: string; exit: string };
}

interface Platform extends Window {
  API: { cmi: object };
}

/** Its calls fail one way or the other: it knows no learner, and can't keep anything. */
const OUT_OF_ORDER = `<!doctype html>
<html lang="en"><title>A platform</title><link rel="icon" href="data:,">
<script>
  window.told = [];
  const note = (...values) => { told.push(values.join(" ")); return "true"; };
  window.API = {
    LMSInitialize: () => { throw new Error("the session has expired"); },
    LMSGetValue: () => { throw new Error("the session has expired"); },
    LMSSetValue: note,
    LMSFinish: () => note("finished"),
  };
</script>
<iframe title="Lesson" src="content/lessons/${SLUG}/index.html" style="width: 100%; height: 720px">
</iframe></html>`;

/** It keeps what the lesson says, and gives it back at the next visit. */
const PLATFORM = `<!doctype html>
<html lang="en"><title>A platform</title><link rel="icon" href="data:,">
<script src="scorm12.min.js"></script>
<script>
  window.API = new Scorm12API({ logLevel: 5 });
  const kept = localStorage.getItem("platform") ?? '{"core": {"student_id": "s-17"}}';
  API.loadFromJSON(JSON.parse(kept));
  const keep = () => localStorage.setItem("platform", JSON.stringify(API.cmi));
  API.on("LMSCommit", keep);
  API.on("LMSFinish", keep);
</script>
<iframe title="Lesson" src="content/lessons/${SLUG}/index.html" style="width: 100%; height: 720px">
</iframe></html>`;

interface Named {
  name: string;
  title: string;
  stretch?: boolean;
}

const { tasks } = JSON.parse(readFileSync(join(LESSON, "lesson.json"), "utf8")) as {
  tasks: Named[];
};
const wanted = tasks.filter(({ stretch }) => !stretch).length;

test("a lesson tells a platform how far it has come, and goes on from there @once", async ({
  page,
}) => {
  test.slow();
  const folder = mkdtempSync(join(tmpdir(), "platform-"));
  const site = new OwnSite(folder);
  try {
    const files = await scormFiles(SLUG, DIST);
    unpackAndCheck(zip(files), folder);
    writeFileSync(join(folder, "index.html"), PLATFORM);
    copyFileSync(RUNTIME, join(folder, "scorm12.min.js"));
    await site.serve();

    // The watch of fixtures.ts knows the site's own server, not this one.
    const complaints: string[] = [];
    page.on("response", (response) => {
      if (!response.ok()) complaints.push(`${response.status()} ${response.url()}`);
    });
    page.on("pageerror", (error) => complaints.push(error.message));
    page.on("console", (message) => {
      if (message.type() === "error") complaints.push(message.text());
    });
    page.on("request", (request) => {
      const local = request.url().startsWith(site.url) || request.url().startsWith("blob:");
      if (!local && !request.url().startsWith("data:")) complaints.push(request.url());
    });
    const kept = () =>
      page.evaluate(() => {
        const { cmi } = (window as unknown as Platform).API;
        return JSON.parse(JSON.stringify(cmi)) as Kept;
      });

    await page.goto(site.url);
    const lesson = page.frameLocator("iframe");
    await expect(lesson.getByRole("heading", { level: 1 })).toBeVisible();
    await expect.poll(async () => (await kept()).core.lesson_status).toBe("incomplete");
    expect((await kept()).core.score.raw).toBe("0");
    await expect(lesson.getByRole("link", { name: "Lessons", exact: true })).toHaveCount(0);

    const [first] = tasks;
    const task = lesson.getByRole("article", { name: first?.title ?? "", exact: true });
    await task.scrollIntoViewIfNeeded();
    const solution = readFileSync(join(LESSON, first?.name ?? "", "solution.py"), "utf8");
    await expect(task.getByRole("button", { name: "Check my work" })).toBeVisible();
    await task.locator("bugbot-lab").evaluate((lab: HTMLElement & { program: string }, text) => {
      lab.program = text;
    }, solution);
    await task.getByRole("button", { name: "Check my work" }).click();
    const mark = task.getByRole("status", { name: "Mark" });
    await expect(mark).toContainText("Passed.", { timeout: 90_000 });

    const share = String(Math.round(100 / wanted));
    await expect.poll(async () => (await kept()).core.score.raw).toBe(share);
    const now = await kept();
    expect(now.core.lesson_status).toBe("incomplete");
    expect(now.suspend_data.length).toBeLessThan(1000);
    expect(now.suspend_data).toContain(`${SLUG}/${first?.name}`);

    // Another device: nothing but what the platform has kept.
    await page.evaluate(() => {
      document.querySelector("iframe")?.remove();
      const platform = localStorage.getItem("platform") ?? "";
      localStorage.clear();
      localStorage.setItem("platform", platform);
    });
    const left = await page.evaluate(() => JSON.parse(localStorage.getItem("platform") ?? ""));
    expect(left.core.exit).toBe("suspend");
    expect(left.core.session_time).toMatch(/^\d\d+:\d\d:\d\d(\.\d+)?$/);
    await page.reload();
    await task.scrollIntoViewIfNeeded();
    await expect(mark).toContainText("You passed this task", { timeout: 30_000 });
    expect((await kept()).core.score.raw).toBe(share);
    expect(complaints).toEqual([]);
  } finally {
    await site.cut();
    rmSync(folder, { recursive: true });
  }
});

/** As a platform does: unpacked by somebody else's reader, every file that the manifest lists is there. */
function unpackAndCheck(archive: Buffer, folder: string): void {
  const content = join(folder, "content");
  const file = join(folder, "lesson.zip");
  write(file, archive);
  execFileSync("python3", ["-m", "zipfile", "-e", file, content]);
  const there = filesBelow(content);
  const manifest = readFileSync(join(content, "imsmanifest.xml"), "utf8");
  const parse = "import sys, xml.dom.minidom as m; m.parse(sys.argv[1])";
  execFileSync("python3", ["-c", parse, join(content, "imsmanifest.xml")]);
  const listed = [...manifest.matchAll(/<file href="([^"]+)"/g)].map(([, href]) => href ?? "");
  expect(["imsmanifest.xml", ...listed].sort()).toEqual(there);
  const launch = /adlcp:scormtype="sco" href="([^"]+)"/.exec(manifest)?.[1] ?? "";
  expect(listed).toContain(launch);
  expect(dirname(launch)).toBe(`lessons/${SLUG}`);
}

test("where a platform's calls throw or are missing the lesson works, is finished, and keeps nothing for the next learner @once", async ({
  page,
}) => {
  test.slow();
  const folder = mkdtempSync(join(tmpdir(), "platform-"));
  const site = new OwnSite(folder);
  try {
    unpackAndCheck(zip(await scormFiles(SLUG, DIST)), folder);
    writeFileSync(join(folder, "index.html"), OUT_OF_ORDER);
    await site.serve();
    const errors: string[] = [];
    page.on("pageerror", (error) => errors.push(error.message));
    const told = () => page.evaluate("told") as Promise<string[]>;

    await page.goto(site.url);
    const lesson = page.frameLocator("iframe");
    await expect.poll(told).toContain("cmi.core.lesson_status incomplete");
    const task = lesson.getByRole("article", { name: tasks[0]?.title ?? "", exact: true });
    await task.scrollIntoViewIfNeeded();
    await task.getByRole("button", { name: "Show hint 1" }).click();
    await expect(task.getByRole("button", { name: "Show hint 2" })).toBeVisible();
    // It is told each time, though nobody says that it is kept.
    await page.evaluate("told.length = 0; document.querySelector('iframe').remove()");
    expect((await told()).at(-1)).toBe("finished");
    expect(await told()).toContain("cmi.core.exit suspend");
    expect(await page.evaluate(() => Object.keys(localStorage))).toEqual([]);
    expect(errors).toEqual([]);
  } finally {
    await site.cut();
    rmSync(folder, { recursive: true });
  }
});
