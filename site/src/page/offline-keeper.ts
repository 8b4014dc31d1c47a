/**
 * The page's side of what is kept for use without a network: it starts the service worker
 * (site/src/offline) and talks with it. May import `ui` and, of `offline`, the messages and `drop`.
 */

import { clearCaches } from "../offline/drop.ts";
import type { FromKeeper, KeeperStatus, ToKeeper } from "../offline/messages.ts";
import { remember } from "../ui/dom.ts";

export type Obstacle = "insecure" | "unable";

/** Why nothing can be kept here; null if it can. */
export function obstacle(): Obstacle | null {
  if (!isSecureContext) return "insecure";
  return "serviceWorker" in navigator ? null : "unable";
}

/**
 * Keeps the site and Python on this device, and what the page has used so far. Resolves when the
 * service worker is done; how far it is, `status` tells. Rejects if the browser refuses.
 */
export async function keep(root: string, withNumpy = false): Promise<void> {
  remember("offline", "yes");
  // Asked for by name each time: a copy of the script that is hours old would hide a new version.
  const options = { scope: root, updateViaCache: "none" } as const;
  const registration = await navigator.serviceWorker.register(`${root}sw.js`, options);
  await begun(registration);
  // NumPy, say, if a program had it before there was a service worker to keep it.
  const used = performance.getEntriesByType("resource").map(({ name }) => name);
  const parts: Extract<ToKeeper, { kind: "keep" }>["parts"] = ["site", "python"];
  if (withNumpy) parts.push("numpy");
  await ask(registration.active, { kind: "keep", parts, used });
}

/** What is on this device; null if nothing was ever kept, or it has been removed. */
export async function status(root: string): Promise<KeeperStatus | null> {
  const registration = await navigator.serviceWorker.getRegistration(root);
  if (!registration?.active) return null;
  const answer = await ask(registration.active, { kind: "status" });
  return answer.kind === "status" ? answer.status : null;
}

/** Takes everything off this device but what the reader has made. */
export async function remove(root: string): Promise<void> {
  remember("offline", "no");
  const registration = await navigator.serviceWorker.getRegistration(root);
  if (!registration) return;
  // A new version that is on its way has what it fetches to itself: it has to stop as well.
  const { active, waiting, installing } = registration;
  const workers = [installing, waiting, active].filter((worker) => worker !== null);
  const answers = workers.map((worker) => ask(worker, { kind: "remove" }));
  await Promise.race([Promise.allSettled(answers), after(ANSWER_MS)]);
  await registration.unregister();
  // Whatever a worker did not get round to.
  await clearCaches(registration.scope);
}

/** A worker that does not answer for so long does not answer at all [ms]. */
const ANSWER_MS = 5000;

function after(ms: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, ms));
}

/** Has the version that waits take over, and shows this page anew with it. */
export function takeOver(waiting: ServiceWorker): void {
  waiting.addEventListener("statechange", () => {
    if (waiting.state === "activated") location.reload();
  });
  say(waiting, { kind: "take over" }, null);
}

/** Resolves when the registration has an active worker; rejects if it can't get one. */
function begun({ active, installing, waiting }: ServiceWorkerRegistration): Promise<void> {
  const first = installing ?? waiting;
  if (active || !first) return Promise.resolve();
  return new Promise((resolve, reject) => {
    first.addEventListener("statechange", () => {
      if (first.state === "activated") resolve();
      if (first.state === "redundant") reject(new Error("a file of the site can't be had"));
    });
  });
}

function ask(worker: ServiceWorker | null, message: ToKeeper): Promise<FromKeeper> {
  const channel = new MessageChannel();
  return new Promise((resolve, reject) => {
    if (!worker) return reject(new Error("the service worker is gone"));
    channel.port1.onmessage = (event: MessageEvent<FromKeeper>) => {
      channel.port1.close();
      resolve(event.data);
    };
    say(worker, message, channel.port2);
  });
}

function say(worker: ServiceWorker, message: ToKeeper, port: MessagePort | null): void {
  worker.postMessage(message, port ? [port] : []);
}
