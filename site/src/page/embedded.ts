/**
 * A page in a frame of another site: `?embed`, marked by early.ts on the root element. A lab in it
 * begins as the address says, or, `?embed=host`, as the page around it does, which talks with it
 * through a port (site/src/embed). May import `trace`, `ui`, `runtime` and the messages of
 * `embed`.
 */
import { type Greeting, HELLO, type Start } from "../embed/messages.ts";
import type { Runtime } from "../runtime/client.ts";
import type { World } from "../trace/events.ts";
import { readAddress } from "./address.ts";
import { noWorld, talk } from "./embedded-talk.ts";
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

/** A reader who scrolls to and fro should not start Python each time [ms]. */
const OUT_OF_SIGHT_MS = 5000;

/** Many labs on a page would each keep an interpreter: one that nobody sees gives its own back. */
export function restOutOfSight(runtime: Runtime): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const observer = new IntersectionObserver((entries) => {
    clearTimeout(timer);
    const isSeen = entries.at(-1)?.isIntersecting ?? true;
    if (isSeen) void runtime.rest(false);
    else timer = setTimeout(() => void runtime.rest(true), OUT_OF_SIGHT_MS);
  });
  observer.observe(document.documentElement);
}

interface Asked {
  start: Start;
  port: MessagePort | null;
  problem: string | null;
}

/** A page around this one that knows of `embed.js` answers at once; a busy one has so long [ms]. */
const GREETING_MS = 10_000;

/** Waits for the page around this one to say how to begin; without an answer the address says it. */
function greeting(): Promise<Asked> {
  return new Promise((resolve) => {
    const listener = ({ source, data, ports }: MessageEvent<Greeting | null>): void => {
      if (source !== parent || data?.kind !== HELLO) return;
      removeEventListener("message", listener);
      resolve({ start: checked(data.start), port: ports[0] ?? null, problem: null });
    };
    addEventListener("message", listener);
    setTimeout(() => void fromAddress().then(resolve), GREETING_MS);
    // There is nothing in it that not everybody may know.
    parent.postMessage(HELLO, "*");
  });
}

/** A host may send anything: what does not fit is left out. */
function checked(start: unknown): Start {
  const given = typeof start === "object" && start !== null ? start : {};
  const text = (name: keyof Start): string | null => {
    const value: unknown = (given as Partial<Record<keyof Start, unknown>>)[name];
    return typeof value === "string" ? value : null;
  };
  return {
    program: text("program"),
    world: text("world"),
    seed: text("seed"),
    label: text("label"),
    pickers: "pickers" in given && given.pickers === true,
    name: text("name") ?? "",
  };
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
