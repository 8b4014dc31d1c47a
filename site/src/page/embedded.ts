/**
 * A page in a frame of another site: `?embed`, marked by early.ts on the root element. A lab in it
 * begins as the address says, or, `?embed=host`, as the page around it does, which talks with it
 * through a port (site/src/embed). May import `trace`, `ui` and the messages of `embed`.
 */
import {
  type FromLab,
  type Greeting,
  HELLO,
  type LabState,
  type Start,
  type ToLab,
} from "../embed/messages.ts";
import type { World } from "../trace/events.ts";
import { embedWords } from "../ui/strings.ts";
import { readAddress } from "./address.ts";
import { packedIn, ShareError, unpack } from "./share.ts";
import "./embedded.css";
import type { BugbotLab } from "./lab.ts";

/** What the page is embedded as: not at all, by hand, or by `embed.js`. */
function embedding(): "no" | "frame" | "host" {
  const { embed } = document.documentElement.dataset;
  if (embed === undefined) return "no";
  return embed === "host" && parent !== window ? "host" : "frame";
}

/** Links to other pages leave the frame: its own page is what the other site has chosen. */
export function openLinksOutside(): void {
  for (const link of document.querySelectorAll<HTMLAnchorElement>("a[href]")) {
    if (!link.getAttribute("href")?.startsWith("#")) link.target = "_blank";
  }
}

/** What came of preparing a lab. */
interface Prepared {
  /** To who embeds it; null where nobody talks with it. */
  port: MessagePort | null;
  /** What was asked for and can't be had, or null. */
  problem: string | null;
}

/** Tells the lab, before it is built, how to begin. */
export async function prepareLab(lab: HTMLElement, worlds: readonly World[]): Promise<Prepared> {
  const { start, port, problem } = embedding() === "host" ? await greeting() : await fromAddress();
  const { program, label, pickers, name } = start;
  const wanted = Object.entries({ world: start.world, seed: start.seed });
  const query = new URLSearchParams(
    wanted.flatMap(([key, value]) => (value ? [[key, value]] : [])),
  );
  const place = readAddress(query.toString(), worlds);
  lab.toggleAttribute("pickers", pickers);
  lab.setAttribute("world", place.world);
  lab.setAttribute("seed", String(place.seed));
  if (program !== null) lab.setAttribute("program", program);
  if (label !== null) lab.setAttribute("label", label);
  // What is kept here is kept apart for each site that embeds a lab, and for each lab of it.
  lab.id = `lab of ${embedder()} ${name}`.trim().replaceAll(/\s+/g, "-");
  const unknown = place.unknownWorld === null ? null : noWorld(place.unknownWorld, worlds);
  return { port, problem: problem ?? unknown ?? place.seedProblem };
}

/** Says what could not be had, and answers the page around the lab if there is one that asks. */
export function connectLab(
  lab: BugbotLab,
  { port, problem }: Prepared,
  worlds: readonly World[],
): void {
  if (problem !== null) void lab.updateComplete.then(() => lab.say({ text: problem }));
  if (port) talk(lab, port, worlds);
}

function talk(lab: BugbotLab, port: MessagePort, worlds: readonly World[]): void {
  const say = (message: FromLab): void => port.postMessage(message);
  const tell = (): void => {
    const { program, world, seed } = lab;
    say({ kind: "state", state: { program, world, seed } });
  };
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
  /** Whatever comes after a change waits until the change is made. */
  let changed = lab.updateComplete.then(tell);
  port.onmessage = async ({ data }: MessageEvent<ToLab>): Promise<void> => {
    if (data.kind === "set") changed = changed.then(() => set(data.state));
    await changed;
    if (data.kind === "stop") lab.stop();
    if (data.kind === "seek") lab.seek(data.seconds);
    if (data.kind !== "run") return;
    const { id } = data;
    try {
      say({ kind: "outcome", id, outcome: await lab.run() });
    } catch (error) {
      say({ kind: "failed", id, message: error instanceof Error ? error.message : String(error) });
    }
  };
  lab.addEventListener("place-change", tell);
  lab.addEventListener("program-change", tell);
  new ResizeObserver(() => {
    say({ kind: "height", pixels: Math.ceil(document.body.getBoundingClientRect().height) });
  }).observe(document.body);
}

function noWorld(name: string, worlds: readonly World[]): string {
  return embedWords.noWorld(name, worlds.map((world) => world.name).join(", "));
}

interface Asked {
  start: Start;
  port: MessagePort | null;
  problem: string | null;
}

/** Waits for the page around this one to say how to begin. */
function greeting(): Promise<Asked> {
  return new Promise((resolve) => {
    const listener = ({ source, data, ports }: MessageEvent<Greeting>): void => {
      if (source !== parent || data?.kind !== HELLO) return;
      removeEventListener("message", listener);
      resolve({ start: data.start, port: ports[0] ?? null, problem: null });
    };
    addEventListener("message", listener);
    // There is nothing in it that not everybody may know.
    parent.postMessage(HELLO, "*");
  });
}

async function fromAddress(): Promise<Asked> {
  const query = new URLSearchParams(location.search);
  const start: Start = {
    program: null,
    world: query.get("world"),
    seed: query.get("seed"),
    label: query.get("label"),
    pickers: query.has("pickers"),
    name: query.get("name") ?? "",
  };
  const packed = packedIn(location.hash);
  if (packed === null) return { start, port: null, problem: null };
  try {
    return { start: { ...start, program: await unpack(packed) }, port: null, problem: null };
  } catch (error) {
    if (!(error instanceof ShareError)) throw error;
    return { start, port: null, problem: error.message };
  }
}

/** The site that has this page in a frame. */
function embedder(): string {
  if (parent === window) return "";
  const [first] = location.ancestorOrigins ?? [];
  if (first) return first;
  return document.referrer ? new URL(document.referrer).origin : "";
}
