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
  await sideBySide([
    { name: "types of TypeScript", commands: [["npx", "tsc", "-p", "."]] },
    {
      name: "types of Python",
      commands: [
        [
          venvTool("mypy"),
          "bugbot",
          "mapping",
          "performer",
          "sandbox",
          "grader",
          "bridge",
          "sketch",
        ],
      ],
      cwd: python,
    },
  ]);
  const unit = ["--config", "tests/playwright.config.ts", "--project=unit"];
  await sideBySide([
    {
      name: "Python tests",
      // Two at a time: they take twice as long as what stands beside them.
      commands: [[venvTool("python"), "-m", "pytest", "-n", "2", "--dist", "worksteal"]],
      cwd: python,
    },
    {
      name: "build, kept figures, bytes, unit tests",
      commands: [
        ["node", "site/build/build.mjs"],
        // All must be up to date; one in 25 is measured again.
        ["node", "site/build/lesson-figures.mjs", "--check", "--one-in", "25"],
        ["node", "site/build/budget.mjs"],
        ["npx", "playwright", "test", ...unit],
      ],
    },
  ]);
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
 * Run a few parts at the same time, where each alone would leave a core idle; the commands of one part
 * come one after the other. What a part says is shown when it has ended. Ends this process if one of
 * them fails.
 * @param {{ name: string, commands: string[][], cwd?: string }[]} parts
 */
export async function sideBySide(parts) {
  console.log(`\n== ${parts.map(({ name }) => name).join(", side by side with ")}`);
  const start = Date.now();
  const codes = await Promise.all(
    parts.map(async ({ name, commands, cwd = ROOT }) => {
      let said = "";
      let code = 0;
      for (const [command = "", ...args] of commands) {
        if (code !== 0) break;
        code = await heard(command, args, cwd, (text) => {
          said += text;
        });
      }
      console.log(`${said}\n== ${name}: ${((Date.now() - start) / 1000).toFixed(1)} s`);
      return code;
    }),
  );
  const failed = parts.filter((_part, index) => codes[index] !== 0);
  for (const { name } of failed) console.error(`${name}: failed`);
  if (failed.length > 0) process.exit(1);
}

/**
 * Run a command; what it says goes to `hear`. Gives its exit status.
 * @param {string} command
 * @param {string[]} args
 * @param {string} cwd
 * @param {(text: string) => void} hear
 * @returns {Promise<number>}
 */
function heard(command, args, cwd, hear) {
  const shell = process.platform === "win32";
  const child = spawn(command, args, { cwd, shell, stdio: ["ignore", "pipe", "pipe"] });
  for (const stream of [child.stdout, child.stderr]) stream.setEncoding("utf8").on("data", hear);
  return new Promise((resolve) => {
    child.on("error", (error) => hear(error.message));
    child.on("close", (code) => resolve(code ?? 1));
  });
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) await check();
