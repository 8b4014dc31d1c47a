/** Carries programs out in the sandbox of `mark-all`: the locked-down Python under Node. */
import { spawn } from "node:child_process";
import { cpSync, linkSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { buffer } from "node:stream/consumers";
import { CACHE, ROOT } from "../../site/build/files.mjs";
import { bundle, options, prepareSandbox } from "../../site/build/sandbox.mjs";

const LONGEST_MS = 120_000;

/**
 * A folder with the sandbox's files in it, and a function that carries a program out there and resolves
 * to what it printed.
 * @param {NodeJS.ProcessEnv} [env]
 */
export async function sandboxForWays(env = {}) {
  const { folder } = await prepareSandbox();
  const own = mkdtempSync(join(CACHE, "sandbox-test-"));
  for (const file of readdirSync(folder)) {
    if (file !== "loader") linkSync(join(folder, file), join(own, file));
  }
  cpSync(join(folder, "loader"), join(own, "loader"), { recursive: true });
  await bundle(join(ROOT, "tests/ways/in-node.ts"), own, "entry.mjs");
  const world = JSON.parse(readFileSync(join(ROOT, "py/bugbot/worlds/empty.json"), "utf8"));
  /** @param {string} program */
  const run = async (program) => {
    const command = [...options(own), join(own, "entry.mjs")];
    const child = spawn(process.execPath, command, { env, timeout: LONGEST_MS });
    child.stdin.end(JSON.stringify({ world, program }));
    const [said, complaint] = await Promise.all([buffer(child.stdout), buffer(child.stderr)]);
    if (complaint.length > 0) throw new Error(`Node complains: ${complaint}`);
    return said.toString("utf8");
  };
  return { run, remove: () => rmSync(own, { recursive: true }) };
}
