/** npm run build: the static site in dist/, ready for any host and any folder of it. */
import { messageOf } from "./files.mjs";
import { ensureInstalled, fail } from "./install.mjs";

export async function build() {
  ensureInstalled();
  const { build: viteBuild } = await import("vite");
  try {
    await viteBuild({ configFile: new URL("../../vite.config.js", import.meta.url).pathname });
  } catch (error) {
    fail(`The site could not be built.\n${messageOf(error)}`);
  }
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  await build();
  console.log("built: dist/");
}
