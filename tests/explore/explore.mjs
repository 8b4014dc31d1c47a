/** npm run explore: the reference explorer on many mats, as a table; see explore.py. */

import { ROOT } from "../../site/build/files.mjs";
import { ensureInstalled, run } from "../../site/build/install.mjs";

ensureInstalled();
const { ensureVenv, venvTool } = await import("../setup.mjs");
ensureVenv();
run(venvTool("python"), ["tests/explore/explore.py", ...process.argv.slice(2)], { cwd: ROOT });
