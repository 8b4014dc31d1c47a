/** npm start: set up, build, and serve the built site on http://127.0.0.1:4173 (PORT changes it). */
import { join } from "node:path";
import { build } from "./build.mjs";
import { messageOf, ROOT } from "./files.mjs";
import { fail } from "./install.mjs";

const port = Number(process.env.PORT ?? 4173);
if (!Number.isInteger(port) || port < 1 || port > 65535) {
  fail(`PORT should be a whole number from 1 to 65535, not "${process.env.PORT}".`);
}
await build();
const { preview } = await import("vite");
try {
  await preview({
    configFile: join(ROOT, "vite.config.js"),
    preview: { port },
  });
} catch (error) {
  fail(`The site could not be served: ${messageOf(error)}`, `PORT=${port + 1} npm start`);
}
console.log(`\nbugbot lessons is at http://127.0.0.1:${port}/ (Ctrl-C ends it)`);
