/** Finds the programs that set-up needs and says what to do when one is missing. */
import { spawnSync } from "node:child_process";

const OLDEST_PYTHON = { major: 3, minor: 11 };

/**
 * The command of a Python that is new enough.
 * @returns {string}
 */
export function findPython() {
  const seen = [];
  for (const command of ["python3", "python", "python3.14", "python3.13", "python3.12"]) {
    const done = spawnSync(command, ["-c", "import sys; print(*sys.version_info[:2])"], {
      encoding: "utf8",
    });
    if (done.status !== 0) continue;
    const [major = 0, minor = 0] = done.stdout.trim().split(" ").map(Number);
    if (
      major > OLDEST_PYTHON.major ||
      (major === OLDEST_PYTHON.major && minor >= OLDEST_PYTHON.minor)
    ) {
      return command;
    }
    seen.push(`${command} is ${major}.${minor}`);
  }
  throw new Error(
    `Python ${OLDEST_PYTHON.major}.${OLDEST_PYTHON.minor} or newer is needed` +
      `${seen.length > 0 ? ` (${seen.join(", ")})` : ", and none was found"}.\n` +
      "Remedy: install it from python.org or your system's packages and start again.",
  );
}

/**
 * Runs a command to its end; what it said last is the error if it fails.
 * @param {string} command
 * @param {string[]} args
 */
export function runTool(command, args) {
  const done = spawnSync(command, args, { encoding: "utf8" });
  if (done.status !== 0) {
    const lines = (done.stderr || done.error?.message || "").trim().split("\n");
    throw new Error(lines.at(-1) || `${command} ended with status ${done.status}`);
  }
}
