/** npm run build: the static site in dist/, ready for any host and any folder of it. */
import { join } from "node:path";
import { messageOf, ROOT } from "./files.mjs";
import { ensureInstalled, fail } from "./install.mjs";

export async function build() {
  ensureInstalled();
  const { build: viteBuild } = await import("vite");
  try {
    await viteBuild({ configFile: join(ROOT, "vite.config.js") });
  } catch (error) {
    fail(`The site could not be built.\n${messageOf(error)}`);
  }
}

if (process.argv[1] === import.meta.filename) {
  await build();
  console.log("built: dist/");
}
