/** npm run check: the quick half of the tests: format, lint, types, unit, bytes. */

import { spawn } from "node:child_process";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { ROOT } from "../site/build/files.mjs";
import { ensureInstalled, run } from "../site/build/install.mjs";

export async function check() {
  ensureInstalled();
  const { ensureVenv, venvTool } = await import("./setup.mjs");
  ensureVenv();
  const python = join(ROOT, "py");
  const config = ["--config", "py/pyproject.toml"];
  const folders = ["py", "tests", "lessons"];
  step("format and lint", () => {
    run("npx", ["biome", "ci", "."]);
    run(venvTool("ruff"), ["format", "--check", ...config, ...folders]);
    run(venvTool("ruff"), ["check", ...config, ...folders]);
  });
  step("types", () => {
    run("npx", ["tsc", "-p", "."]);
    run(venvTool("mypy"), ["bugbot", "mapping", "grader", "bridge", "sketch"], { cwd: python });
  });
  await sideBySide([
    { name: "Python tests", command: venvTool("python"), args: ["-m", "pytest"], cwd: python },
    {
      name: "unit tests",
      command: "npx",
      args: ["playwright", "test", "--config", "tests/playwright.config.ts", "--project=unit"],
    },
  ]);
  step("build", () => run("node", ["site/build/build.mjs"]));
  step("bytes", () => run("node", ["site/build/budget.mjs"]));
}

/**
 * Run one named part and say how long it took.
 * @param {string} name
 * @param {() => void} work
 */
export function step(name, work) {
  console.log(`\n== ${name}`);
  const start = Date.now();
  work();
  console.log(`== ${name}: ${((Date.now() - start) / 1000).toFixed(1)} s`);
}

/**
 * Run a few commands at the same time, where each alone would leave a core idle; what each says is
 * shown when it has ended. Ends this process if one of them fails.
 * @param {{ name: string, command: string, args: string[], cwd?: string }[]} parts
 */
export async function sideBySide(parts) {
  console.log(`\n== ${parts.map(({ name }) => name).join(", side by side with ")}`);
  const start = Date.now();
  const codes = await Promise.all(
    parts.map(({ name, command, args, cwd = ROOT }) => {
      const shell = process.platform === "win32";
      const child = spawn(command, args, { cwd, shell, stdio: ["ignore", "pipe", "pipe"] });
      let said = "";
      for (const stream of [child.stdout, child.stderr]) {
        stream.setEncoding("utf8").on("data", (text) => {
          said += text;
        });
      }
      return new Promise((resolve) => {
        child.on("error", (error) => {
          said += error.message;
        });
        child.on("close", (code) => {
          console.log(`${said}\n== ${name}: ${((Date.now() - start) / 1000).toFixed(1)} s`);
          resolve(code);
        });
      });
    }),
  );
  const failed = parts.filter((_part, index) => codes[index] !== 0);
  for (const { name } of failed) console.error(`${name}: failed`);
  if (failed.length > 0) process.exit(1);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) await check();
