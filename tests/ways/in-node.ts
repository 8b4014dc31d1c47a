/**
 * Runs in the sandbox, in place of its performer: a program on an empty mat, as in a page, without the
 * fences that Python has while it marks. In: JSON, the world and the program. Out: what it printed, also
 * if it broke.
 */
import { readFileSync, writeSync } from "node:fs";
import { startConfined } from "../../site/sandbox/confined.ts";

/** `bridge.session`, as far as it is called from here. */
interface Session {
  run(
    program: string,
    worldJson: string,
    seed: number,
    limitsJson: string,
    send: (events: string) => void,
    begin: () => void,
    keep: (text: string) => void,
    still: () => void,
  ): void;
}

const exit = process.exit.bind(process);
const { sealed, numpy } = await startConfined(["bridge.session"]);
const session = sealed.module("bridge.session") as Session;
const { world, program } = JSON.parse(readFileSync(0, "utf8")) as Record<string, string>;
if (program?.includes("import numpy")) sealed.installWheel(numpy);

let sent = "";
let unsent = "";
/** Takes rows of the trace; a program may send what is none. */
function send(events: string): void {
  try {
    const rows = JSON.parse(events) as unknown[][];
    for (const [kind, , , text] of rows) if (kind === "print") sent += text;
    unsent = "";
  } catch {
    // A forged message.
  }
}
try {
  session.run(
    program ?? "",
    JSON.stringify(world),
    1,
    "{}",
    send,
    () => {},
    (text) => {
      unsent += text;
    },
    () => {},
  );
} catch (error) {
  unsent += `\nbroken: ${error}`;
}
const bytes = new TextEncoder().encode(sent + unsent);
for (let at = 0; at < bytes.length; ) {
  try {
    at += writeSync(1, bytes.subarray(at));
  } catch (error) {
    // The pipe is full.
    if ((error as NodeJS.ErrnoException).code !== "EAGAIN") throw error;
  }
}
exit(0);
