/**
 * The lab's side of its talk with the page around it: whatever that sends, each run it asks for comes to
 * an outcome or to an error, and what can't be done is said in the lab. May import `trace`, `ui` and, of
 * `embed`, the messages.
 */
import type { FromLab, LabState } from "../embed/messages.ts";
import type { World } from "../trace/events.ts";
import { outcomeOf } from "../trace/outcome.ts";
import { embedWords } from "../ui/strings.ts";
import { stoppedTrace } from "./empty-trace.ts";
import { readHostMessage } from "./host-message.ts";
import { HostRuns } from "./host-runs.ts";
import type { BugbotLab } from "./lab.ts";

export function talk(lab: BugbotLab, port: MessagePort, worlds: readonly World[]): void {
  const say = (message: FromLab): void => port.postMessage(message);
  const tell = (): void => {
    const { program, world, seed } = lab;
    say({ kind: "state", state: { program, world, seed } });
  };
  const runs = new HostRuns(
    {
      ready: () => lab.ready(),
      run: () => lab.run(),
      stop: () => lab.stop(),
      unbegun: () => outcomeOf(stoppedTrace(worldOf(lab, worlds))),
    },
    {
      onOutcome: (id, outcome) => say({ kind: "outcome", id, outcome }),
      onFailed: (id, message) => say({ kind: "failed", id, message }),
    },
  );
  const set = async ({ world, seed, program }: Partial<LabState>): Promise<void> => {
    // The world first: with it comes the program that belongs to it.
    const known = worlds.some(({ name }) => name === world);
    if (world !== undefined && known) lab.world = world;
    if (seed !== undefined) lab.seed = seed;
    await lab.updateComplete;
    if (program !== undefined) lab.program = program;
    if (world !== undefined && !known) lab.say({ text: noWorld(world, worlds) });
    tell();
  };
  const obey = async (data: unknown): Promise<void> => {
    const message = readHostMessage(data);
    if (message.kind === "set") await set(message.state);
    if (message.kind === "stop") runs.stop();
    if (message.kind === "seek") lab.seek(message.seconds);
    if (message.kind === "run") runs.ask(message.id);
    if (message.kind === "wrong") {
      lab.say({ text: embedWords.wrong(message.what, message.got) });
      // The page around has to hear what is still so.
      tell();
    }
    if (message.kind === "unknown") lab.say({ text: embedWords.unknown });
  };
  /** One after the other: what comes after a change waits until the change is made. */
  let done = lab.updateComplete.then(tell);
  port.onmessage = ({ data }: MessageEvent<unknown>): void => {
    done = done.then(() => obey(data));
  };
  lab.addEventListener("place-change", tell);
  lab.addEventListener("program-change", tell);
  addEventListener("pagehide", () => say({ kind: "gone" }));
  new ResizeObserver(() => {
    say({ kind: "height", pixels: Math.ceil(document.body.getBoundingClientRect().height) });
  }).observe(document.body);
}

function worldOf(lab: BugbotLab, worlds: readonly World[]): World {
  const world = worlds.find(({ name }) => name === lab.world);
  if (!world) throw new Error(`the lab is on "${lab.world}", which is no world of this site`);
  return world;
}

/** What is wrong with a world's name, in words. */
export function noWorld(name: string, worlds: readonly World[]): string {
  return embedWords.noWorld(name, worlds.map((world) => world.name).join(", "));
}
