/** The built site on a plain static host of its own. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";

/**
 * @param {string} dist folder of the built site
 * @returns {Promise<{ url: string, cut: () => Promise<void> }>} `cut` ends it, as when the network goes
 */
export async function serve(dist) {
  const script = join(ROOT, "tests/static-server.mjs");
  const server = spawn("node", [script, "0", "/some/school/", dist], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  const ended = once(server, "exit");
  process.once("exit", () => server.kill());
  const [said] = await Promise.race([
    once(server.stdout, "data"),
    ended.then(() => Promise.reject(new Error("the static server has ended at once"))),
  ]);
  return {
    url: String(said).trim(),
    cut: async () => {
      server.kill();
      await ended;
    },
  };
}
