/**
 * The service worker: gives out the site from this device, so that it works without a network.
 * The build makes `sw.js` of it, with the list of the site's files. Imports nothing but this room.
 *
 * A version, once it is kept, is given out until the reader takes the next one or closes all of its
 * pages: nothing changes under somebody's hands.
 */
import type { FromKeeper, ToKeeper } from "./messages.ts";
import { isNoRoom, Shelf } from "./shelf.ts";
import { NO_ROOM, type SiteFiles } from "./site-files.ts";

/** Written in front of this script by the build. */
declare const SITE_FILES: SiteFiles;

/** What is used here of a service worker's world; the site's other code has a window's. */
interface Lasting extends Event {
  waitUntil(work: Promise<unknown>): void;
}
interface Asked extends Lasting {
  readonly request: Request;
  respondWith(response: Promise<Response>): void;
}
interface Told extends Lasting {
  readonly data: ToKeeper;
  readonly ports: readonly MessagePort[];
}
interface ServiceWorkerWorld {
  readonly registration: ServiceWorkerRegistration;
  readonly clients: {
    claim(): Promise<void>;
    matchAll(options: { type: "window"; includeUncontrolled: boolean }): Promise<{ url: string }[]>;
  };
  skipWaiting(): Promise<void>;
  addEventListener(kind: "install" | "activate", listener: (event: Lasting) => void): void;
  addEventListener(kind: "fetch", listener: (event: Asked) => void): void;
  addEventListener(kind: "message", listener: (event: Told) => void): void;
}
const world = self as unknown as ServiceWorkerWorld;

const shelf = new Shelf(world.registration.scope, SITE_FILES, {
  caches,
  fetch: (address, options) => fetch(address, options),
  hash: async (bytes) => {
    const digest = await crypto.subtle.digest("SHA-256", bytes);
    return btoa(String.fromCharCode(...new Uint8Array(digest)));
  },
});
/** A frame inside a page, where its workers are made (runtime/worker-frame.ts). */
const WORKERS_FRAME = /\/worker-frame-[^/]*\.html$/;
/** One fetching after the other: what one has fetched is not missing for the next. */
let queue: Promise<void> = Promise.resolve();
let queued = 0;
let problem: string | null = null;

world.addEventListener("install", (event) => event.waitUntil(shelf.install()));

world.addEventListener("activate", (event) => {
  event.waitUntil(world.clients.claim().then(tidy));
});

world.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method === "GET" && shelf.answers(request.url)) {
    const answer = shelf.answer(request);
    event.respondWith(answer);
    // What it has fetched is kept behind the answer.
    event.waitUntil(answer.then(() => shelf.settled()).catch(() => {}));
  }
});

world.addEventListener("message", (event) => {
  const answer = (message: FromKeeper): void => event.ports[0]?.postMessage(message);
  event.waitUntil(obey(event.data).then(answer));
});

async function obey(message: ToKeeper): Promise<FromKeeper> {
  switch (message.kind) {
    case "status": {
      const parts = await shelf.status();
      return { kind: "status", status: { parts, busy: queued > 0, problem } };
    }
    case "keep":
      await keep(message);
      await tidy();
      return { kind: "done" };
    case "take over":
      await world.skipWaiting();
      return { kind: "done" };
    case "remove":
      await shelf.remove();
      await world.registration.unregister();
      return { kind: "done" };
  }
}

async function keep({ parts, used }: Extract<ToKeeper, { kind: "keep" }>): Promise<void> {
  queued += 1;
  queue = queue.then(async () => {
    try {
      await shelf.keep(parts, used);
      problem = null;
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      problem = isNoRoom(error) ? NO_ROOM : message;
    }
  });
  await queue;
  queued -= 1;
}

/** Old versions go as soon as no page of theirs can be open. */
async function tidy(): Promise<void> {
  const { installing, waiting } = world.registration;
  const windows = await world.clients.matchAll({ type: "window", includeUncontrolled: true });
  const pages = windows.filter(({ url }) => !WORKERS_FRAME.test(url));
  if (!installing && !waiting && pages.length <= 1) await shelf.tidy();
}
