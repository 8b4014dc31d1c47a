/**
 * The live figures as the build puts them into a page: the very text that the page's scripts would
 * write, made by running the site's own TypeScript.
 */
import { join } from "node:path";
import { runnerImport } from "vite";
import { ROOT } from "./files.mjs";

/**
 * Name of a figure (`::live NAME`) -> its whole HTML.
 * @returns {Promise<Readonly<Record<string, string>>>}
 */
export async function liveFigures() {
  /** @type {{ module: typeof import("../src/figures/figures.ts") }} */
  const { module } = await runnerImport(join(ROOT, "site/src/figures/figures.ts"), {
    configFile: false,
    logLevel: "error",
  });
  return module.LIVE_FIGURES;
}
