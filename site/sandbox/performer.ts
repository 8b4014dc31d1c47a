/**
 * A process that does one job of a marking with one learner's program, and ends. The site's own worker
 * under Node (confined.ts), with the limits that `sandbox.node` puts on the process.
 *
 *   in    one line of JSON {"job", "program"}, then the end of the input
 *   out   lines: "ready"; "begun"; "beat T" as simulated time passes; then "result JSON", or "died WORDS"
 *         if the interpreter broke, or "failed WORDS" for a fault of ours
 */
import { readFileSync, writeSync } from "node:fs";
import { startConfined } from "./confined.ts";

interface Session {
  missing_modules(program: string): { toJs(): string[] };
}

interface Marking {
  perform(job: string, program: string, beat: (t: number) => void, look: () => void): string;
}

const exit = process.exit.bind(process);

/** One line to whoever started this process; a pipe may take it in parts. */
function say(text: string): void {
  let rest = new TextEncoder().encode(`${text}\n`);
  while (rest.length > 0) {
    try {
      rest = rest.subarray(writeSync(1, rest));
    } catch (error) {
      // The pipe is full: whoever reads it has not got on yet.
      if ((error as NodeJS.ErrnoException).code !== "EAGAIN") throw error;
    }
  }
}

async function main(): Promise<void> {
  const { sealed, numpy, lastWords } = await startConfined(["bridge.session", "bridge.marking"]);
  try {
    const session = sealed.module("bridge.session") as Session;
    const marking = sealed.module("bridge.marking") as Marking;
    say("ready");
    const request: unknown = JSON.parse(readFileSync(0, "utf8"));
    const { job, program } = request as { job: object; program: string };
    if (session.missing_modules(program).toJs().includes("numpy")) sealed.installWheel(numpy);
    say("begun");
    const beat = (t: number): void => say(`beat ${Number(t)}`);
    const look = (): void => sealed.lookAtTheClock();
    say(`result ${marking.perform(JSON.stringify(job), program, beat, look)}`);
  } catch (error) {
    const { name, message } = error instanceof Error ? error : new Error(String(error));
    // As in the page's worker: Python's own exceptions are faults of ours, anything else broke it.
    const what = name === "PythonError" ? "failed" : "died";
    say(`${what} ${JSON.stringify(`${name}: ${message}\n${lastWords}`.slice(0, 4000))}`);
  }
}

try {
  await main();
} catch (error) {
  say(`failed ${JSON.stringify(String(error))}`);
}
// Timers of the interpreter would keep the process waiting.
exit(0);
