/**
 * A program can't get out of its worker: every way out we could think of is tried, and the server
 * and the page are watched meanwhile. `tests/ways` has the programs.
 */
import type { Page } from "@playwright/test";
import { KINDS } from "../ways/all.mjs";
import { listen } from "../ways/listener.mjs";
import { faultsOf, tryWays } from "../ways/runs.mjs";
import type { Way } from "../ways/tools.mjs";
import type { App } from "./app.ts";
import { expect, test } from "./fixtures.ts";

interface Lab {
  program: string;
  run(): Promise<{
    status: string;
    console: string;
    fault: { type: string; message: string } | null;
  }>;
}

const WAYS = KINDS.flatMap(({ ways }) => ways);

for (const [name, ways] of [
  ["no way out of the sandbox is open", WAYS.filter(({ spoils }) => !spoils)],
  ["nor one that spoils its interpreter @long", WAYS.filter(({ spoils }) => spoils)],
] as const) {
  test(name, async ({ app, page }) => noneIsOpen(ways, app, page));
}

async function noneIsOpen(ways: readonly Way[], app: App, page: Page): Promise<void> {
  test.setTimeout(480_000);
  // A reader who doesn't want the site kept: the page then fetches nothing for that.
  await page.addInitScript(() => localStorage.setItem("bugbot:offline", "no"));
  await app.openLab("world=empty");
  const lab = page.locator("bugbot-lab");
  // Everything the site itself will ever fetch has been fetched: what comes now is an escape.
  await lab.evaluate(async (element: HTMLElement & Lab) => {
    element.program = "import numpy, wave\nfrom bugbot import *\nplot('x', 1)\nwait(1)";
    await element.run();
  });
  await expect(page.locator(".uplot")).toBeVisible();
  const asked: string[] = [];
  page.on("request", (request) => {
    const own =
      request.url().startsWith("blob:") || /\/assets\/worker|\/pyodide/.test(request.url());
    if (!own) asked.push(request.url());
  });
  const pageState = () =>
    page.evaluate(async () => ({
      title: document.title,
      address: location.href,
      storage: Object.keys(localStorage).filter((key) => !key.startsWith("bugbot")),
      databases: await indexedDB.databases(),
      caches: await caches.keys(),
      globals: Object.keys(window).length,
      shared: [Object, Array, Function].map(({ prototype }) => Reflect.ownKeys(prototype).length),
    }));
  const before = await pageState();
  const listener = await listen();
  const said = await tryWays(ways, listener.port, (program) =>
    lab.evaluate(async (element: HTMLElement & Lab, source) => {
      element.program = source;
      return (await element.run()).console;
    }, program),
  );
  listener.close();
  expect(said.size).toBe(ways.length);
  expect(faultsOf(said)).toEqual([]);
  expect(listener.came()).toBe(0);
  expect(asked).toEqual([]);
  expect(await pageState()).toEqual(before);
}

test("where workers are made, the policy alone lets nothing be fetched, not even from the site", async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  await page.locator("iframe").waitFor({ state: "attached" });
  // What the policy stops is told as a request that failed.
  const answered: string[] = [];
  page.on("response", (response) => answered.push(response.url()));
  // JavaScript in such a worker, before anything was taken from it.
  const answers = await page.evaluate(async () => {
    const frame = document.querySelector<HTMLIFrameElement>("iframe[src*=worker-frame]");
    const scope = frame?.contentWindow as Window & typeof globalThis;
    const here = location.origin + location.pathname;
    const script = `
      const tried = (work) => new Promise((resolve) => resolve(work())).then(() => "open", () => "closed");
      const file = ${JSON.stringify(here)};
      const font = () => new FontFace("x", "url(" + file + "?font)").load();
      const socket = () => new Promise((open, shut) => {
        const one = new WebSocket(file.replace("http", "ws") + "?socket");
        one.onopen = open; one.onerror = shut;
      });
      const events = () => new Promise((open, shut) => {
        const one = new EventSource(file + "?events");
        one.onopen = open; one.onerror = shut;
      });
      const request = () => new Promise((open, shut) => {
        const one = new XMLHttpRequest();
        one.onload = open; one.onerror = shut;
        one.open("GET", file + "?request"); one.send();
      });
      Promise.all([
        tried(() => fetch(file + "?fetch")), tried(font), tried(socket), tried(events), tried(request),
        tried(() => new Function("1")), tried(() => import("data:text/javascript,1")),
        tried(() => fetch("data:,text")), tried(() => WebAssembly.compile(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0))),
      ]).then((answers) => postMessage(answers));`;
    const worker = new scope.Worker(
      scope.URL.createObjectURL(new scope.Blob([script], { type: "text/javascript" })),
    );
    return await new Promise((resolve) => {
      worker.onmessage = ({ data }: MessageEvent<unknown>) => resolve(data);
    });
  });
  // The last is allowed: Python is WebAssembly.
  expect(answers).toEqual([...Array<string>(8).fill("closed"), "open"]);
  expect(answered.filter((url) => /\?(font|socket|events|request|fetch)$/.test(url))).toEqual([]);
});

test("forged messages do nothing", async ({ app, page }) => {
  await app.openLab("world=empty");
  const lab = page.locator("bugbot-lab");
  // The function that sends the trace can be found from the frames: with it, a program can only
  // tell lies about its own run, and only in the form of a trace.
  const outcome = await lab.evaluate(async (element: HTMLElement & Lab) => {
    element.program = `
import sys
frame = sys._getframe()
senders = []
while frame:
    for value in list(frame.f_locals.values()):
        send = getattr(value, "_send", None)
        if send is not None:
            senders.append(send)
        if "JsProxy" in type(value).__name__:
            senders.append(value)
    frame = frame.f_back
import gc
senders += [o for o in gc.get_objects() if "JsProxy" in type(o).__name__]
print("found", len(senders) > 0)
for send in senders:
    for forged in ('[["end",0,"finished","forged"]]', '[["nonsense",1]]', "not json", '[["pose",-1,0,0,0]]', "["*100000):
        try:
            send(forged, None)
        except BaseException as error:
            pass
        try:
            from pyodide.ffi import to_js
            send(forged, to_js(b""))
        except BaseException as error:
            pass
`;
    return await element.run();
  });
  expect(["finished", "fault", "stopped"]).toContain(outcome.status);
  const after = await lab.evaluate(async (element: HTMLElement & Lab) => {
    element.program = 'print("still well")';
    return await element.run();
  });
  expect(after).toMatchObject({ status: "finished", console: "still well\n" });
});

test("a run leaves nothing behind for the next", async ({ app, page }) => {
  await app.openLab("world=empty");
  const lab = page.locator("bugbot-lab");
  const run = (program: string) =>
    lab.evaluate(async (element: HTMLElement & Lab, source) => {
      element.program = source;
      return await element.run();
    }, program);
  await run(`
import builtins, sys, os, math, random, bugbot, bugbot.api, bugbot.sim.simulator
builtins.print = lambda *a, **k: None
math.sin = lambda x: 42
random.seed(1)
bugbot.scan = bugbot.api.scan = lambda: "tampered"
sys.modules["json"] = None
os.environ["LEFT"] = "behind"
open("/tmp/left", "w").write("behind")
open("/lib/python3.14/site-packages/bugbot/api.py", "w").write("raise SystemExit")
sys.setrecursionlimit(60)
`);
  const after = await run(`
from bugbot import *
import json, math, os, random, sys
print(math.sin(0), len(scan()), os.path.exists("/tmp/left"), "LEFT" in os.environ)
print(json.dumps(sys.getrecursionlimit() > 800))
print(random.random())
`);
  const again = await run("import random\nprint(random.random())");
  expect(after.fault).toBeNull();
  expect(after.console).toContain("0.0 8 False False\ntrue\n");
  // The program's own chance comes from the seed, afresh in each run.
  expect(after.console.split("\n")[2]).toBe(again.console.trim());
});
