/** npm test: set up what is missing, then every test there is. */
import { run } from "../site/build/install.mjs";
import { check, sideBySide, step } from "./check.mjs";

/** The lessons in which every small change of a solution fails its checks or has its reason. */
const CLOSED = ["u8-1-a-map-of-cells", "u8-2-inverse-sensor-model", "u8-3-log-odds"];

const start = Date.now();
await check();
const { ensureBrowser } = await import("./setup.mjs");
ensureBrowser();
// One noise here, and a third of the right and wrong programs; `npm run lesson:check` marks all of them,
// and those that must pass with twenty noises.
step("lessons", () => {
  run("node", ["site/build/lesson-check.mjs", "--seeds", "1", "--one-in", "3"]);
});
// Forty changes of the solutions here; `npm run lesson:mutants` tries them all.
step("a sample of mutants", () =>
  run("node", ["site/build/lesson-mutants.mjs", ...CLOSED, "--sample", "40"]),
);
step("same marks in the browser's Python", () =>
  run("node", ["tests/lessons/same-marks.mjs", "--few"]),
);
step("browser tests", () =>
  run("npx", ["playwright", "test", "--config", "tests/playwright.config.ts", "--project=e2e*"]),
);
// A few stories more in the other engines, where they are installed; Chromium has had them all.
await sideBySide(
  ["firefox", "webkit"].map((engine) => ({
    name: `a few stories in ${engine}`,
    commands: [["node", "tests/engines/run.mjs", "--few", "--only", engine, "--dist", "dist"]],
  })),
);
console.log(`\nall tests passed in ${Math.round((Date.now() - start) / 1000)} s`);
