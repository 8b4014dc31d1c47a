/** The built site on a plain static host of its own. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { ROOT } from "../../site/build/files.mjs";

/**
 * @param {string} dist folder of the built site
 * @param {string[]} [asked] is told each path that it is asked for
 * @returns {Promise<{ url: string, cut: () => Promise<void> }>} `cut` ends it, as when the network goes
 */
export async function serve(dist, asked = []) {
  const script = join(ROOT, "tests/static-server.mjs");
  const server = spawn("node", [script, "0", "/some/school/", dist, "tell"], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  const ended = once(server, "exit");
  process.once("exit", () => server.kill());
  const lines = createInterface(server.stdout);
  const [url] = await Promise.race([
    once(lines, "line"),
    ended.then(() => Promise.reject(new Error("the static server has ended at once"))),
  ]);
  lines.on("line", (line) => asked.push(line));
  return {
    url,
    cut: async () => {
      server.kill();
      await ended;
    },
  };
}
