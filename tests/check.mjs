/** npm run check: the quick half of the tests: format, lint, types, unit, bytes. */

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
  step("Python tests", () => run(venvTool("python"), ["-m", "pytest"], { cwd: python }));
  step("unit tests", () =>
    run("npx", ["playwright", "test", "--config", "tests/playwright.config.ts", "--project=unit"]),
  );
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

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) await check();
