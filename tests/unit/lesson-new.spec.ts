/** A lesson begun with lesson:new is a sound one at once: its starter fails, its solution passes. */
import { spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { newLesson } from "../../site/build/lesson-new.mjs";
import { venvTool } from "../setup.mjs";

let folder: string;

test.beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), "lessons-"));
  cpSync(join(ROOT, "lessons/_template"), join(folder, "_template"), { recursive: true });
  writeFileSync(join(folder, "course.json"), '{ "format": 1, "lessons": ["u8-1-before"] }');
});

test.afterEach(() => rmSync(folder, { recursive: true }));

test("a new lesson has its names filled in, is in the course and passes the standing check", () => {
  const files = newLesson("u9-1-open-doors", folder);
  expect(files).toContain("whole-steps/check.py");
  const about = JSON.parse(readFileSync(join(folder, "u9-1-open-doors/lesson.json"), "utf8"));
  expect(about.title).toBe("Open doors");
  const course = JSON.parse(readFileSync(join(folder, "course.json"), "utf8"));
  expect(course.lessons).toEqual(["u8-1-before", "u9-1-open-doors"]);

  const command = ["-m", "grader", "check", "u9-1-open-doors", "--lessons", folder, "--seeds", "2"];
  const env = { ...process.env, PYTHONPATH: join(ROOT, "py") };
  const done = spawnSync(venvTool("python"), command, { env, encoding: "utf8" });
  expect(done.stdout).toContain("all is well");
  expect(done.status).toBe(0);
});

test("a name that can't be one, or is taken, is refused and nothing is written", () => {
  expect(() => newLesson("Open doors", folder)).toThrow('it got "Open doors"');
  expect(() => newLesson("../doors", folder)).toThrow('it got "../doors"');
  expect(() => newLesson("_template", folder)).toThrow('it got "_template"');
  newLesson("doors", folder);
  expect(() => newLesson("doors", folder)).toThrow("There is a lessons/doors already");
  const course = JSON.parse(readFileSync(join(folder, "course.json"), "utf8"));
  expect(course.lessons).toEqual(["u8-1-before", "doors"]);
});
