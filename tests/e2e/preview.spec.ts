/** The preview for whoever writes a lesson, in the development server: what learners will be told. */
import { spawn } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";

const SLUG = "u8-1-a-map-of-cells";
const LESSON = join(ROOT, "lessons", SLUG);

test("an instructor sees each wrong attempt beside what it earns @once", async ({ page }) => {
  test.slow();
  const server = spawn("node", [join(ROOT, "site/build/dev.mjs")], {
    env: { ...process.env, PORT: "4391", NO_COLOR: "1" },
  });
  try {
    const address = await new Promise<string>((resolve, reject) => {
      let said = "";
      const hear = (text: Buffer): void => {
        said += text;
        const url = /http:\/\/127\.0\.0\.1:\d+\//.exec(said)?.[0];
        if (url) resolve(url);
      };
      server.stdout.on("data", hear);
      server.stderr.on("data", hear);
      server.on("exit", () => reject(new Error(said)));
    });
    await page.goto(`${address}lessons/${SLUG}/`);
    await page.getByRole("link", { name: "What learners are told" }).click();
    await expect(page.getByRole("status")).toHaveText("All marked.", { timeout: 90_000 });

    const { tasks } = JSON.parse(readFileSync(join(LESSON, "lesson.json"), "utf8"));
    for (const { name, title } of tasks as { name: string; title: string }[]) {
      const task = page.getByRole("region", { name: title, exact: true });
      const program = (file: string) =>
        task.getByRole("article", { name: `${name}/${file}`, exact: true });
      await expect(program("solution.py")).toContainText("Passed:");
      await expect(program("starter.py")).toContainText("Not passed:");
      for (const file of readdirSync(join(LESSON, name, "wrong"))) {
        const source = readFileSync(join(LESSON, name, "wrong", file), "utf8");
        const earns = source.split("\n")[0]?.replace("# earns:", "").trim() ?? "";
        const attempt = program(`wrong/${file}`);
        await expect(attempt.getByRole("code")).toContainText(source.split("\n")[1] ?? "");
        await expect(attempt.getByRole("definition").filter({ hasText: earns })).not.toHaveCount(0);
        await expect(attempt).toContainText("That is what it must earn.");
      }
    }
    await expect(page.getByRole("img", { name: /cells outlined/ })).not.toHaveCount(0);
  } finally {
    server.kill();
  }
});
