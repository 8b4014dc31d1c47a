/** Python at work for the authors' page: what it prints, line by line, until somebody leaves. */
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { createInterface } from "node:readline";
import { ROOT } from "../files.mjs";
import { findPython } from "../tools.mjs";

/**
 * Throws an Error with what Python complained of, if it ends with a fault and not because `response`
 * was closed.
 * @param {string[]} args
 * @param {import("node:http").ServerResponse} response
 * @param {readonly number[]} [fine] the exit statuses that are no fault
 * @returns {AsyncGenerator<string>}
 */
export async function* pythonLines(args, response, fine = [0]) {
  const path = [join(ROOT, "py"), process.env.PYTHONPATH ?? ""].filter(Boolean).join(delimiter);
  const child = spawn(python(), args, {
    cwd: ROOT,
    env: { ...process.env, PYTHONPATH: path },
    stdio: ["ignore", "pipe", "pipe"],
    // A group of its own, so that the processes that it starts end with it.
    detached: process.platform !== "win32",
  });
  let left = false;
  const end = () => {
    left = true;
    if (child.exitCode !== null || child.pid === undefined) return;
    if (process.platform === "win32") child.kill();
    else process.kill(-child.pid, "SIGTERM");
  };
  response.on("close", end);
  let complaint = "";
  child.stderr.on("data", (text) => {
    complaint += text;
  });
  const ended = new Promise((resolve, reject) => {
    child.on("error", reject);
    child.on("close", resolve);
  });
  for await (const line of createInterface({ input: child.stdout })) yield line;
  const status = await ended;
  response.off("close", end);
  if (!left && !fine.includes(Number(status))) {
    throw new Error(complaint.trim() || `Python ended with ${status}`);
  }
}

/** That of the tests' environment, which has NumPy, or else the system's. */
function python() {
  const own = join(ROOT, ".venv/bin/python");
  return existsSync(own) ? own : findPython();
}
