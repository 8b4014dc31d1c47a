/**
 * A program can't get out of its worker: every way out we could think of is tried, and the server
 * and the page are watched meanwhile. See ways-out.ts and ways-by-kind.ts for the programs.
 */
import { expect, test } from "./fixtures.ts";
import { WAYS_BY_KIND } from "./ways-by-kind.ts";
import { WAYS_OUT, type WayOut } from "./ways-out.ts";

interface Lab {
  program: string;
  run(): Promise<{
    status: string;
    console: string;
    fault: { type: string; message: string } | null;
  }>;
}

/** Several ways in a run, and one that breaks its interpreter in a run of its own. */
function inRuns(ways: readonly WayOut[]): WayOut[][] {
  const harmless = ways.filter(({ breaks }) => !breaks);
  const runs = ways.filter(({ breaks }) => breaks).map((way) => [way]);
  for (let i = 0; i < harmless.length; i += 8) runs.push(harmless.slice(i, i + 8));
  return runs;
}

/** A program that tries one way after the other, each with the modules as they were before. */
function severalOf(ways: readonly WayOut[]): string {
  const sources = JSON.stringify(ways.map(({ program }) => program));
  // The page sends NumPy to a program that imports it by name, and looks into no text for that.
  const numpy = sources.includes("import numpy") ? "if False: import numpy" : "";
  return `import json, sys
${numpy}
loaded = dict(sys.modules)
finders = list(sys.meta_path)
for source in json.loads(${JSON.stringify(sources)}):
    print("TRYING")
    try:
        exec(compile(source, "way out", "exec"), {"__name__": "__main__", "__builtins__": __builtins__})
    except BaseException as error:
        print("closed:", type(error).__name__, error)
    sys.modules.clear()
    sys.modules.update(loaded)
    sys.meta_path[:] = finders
    sys.setprofile(None)
`;
}

const KINDS = [{ kind: "the first ones", ways: WAYS_OUT }, ...WAYS_BY_KIND];

test("no way out of the sandbox is open", async ({ app, page }) => {
  test.setTimeout(480_000);
  // A reader who doesn't want the site kept: the page then fetches nothing for that.
  await page.addInitScript(() => localStorage.setItem("bugbot:offline", "no"));
  await app.openLab("world=empty");
  const lab = page.locator("bugbot-lab");
  // Everything the site itself will ever fetch has been fetched: what comes now is an escape.
  await lab.evaluate(async (element: HTMLElement & Lab) => {
    element.program = "import numpy, wave";
    await element.run();
  });
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
    }));
  const before = await pageState();
  expect(KINDS.flatMap(({ ways }) => ways).length).toBeGreaterThanOrEqual(70);
  const open: string[] = [];
  for (const ways of KINDS.flatMap((kind) => inRuns(kind.ways))) {
    const { console } = await lab.evaluate(async (element: HTMLElement & Lab, source) => {
      element.program = source;
      return await element.run();
    }, severalOf(ways));
    const told = console.split(/^TRYING$/m).slice(1);
    if (!ways[0]?.breaks) expect(told.length, console).toBe(ways.length);
    for (const [index, text] of told.entries()) {
      const name = ways[index]?.name;
      if (text.includes("OPEN")) open.push(`${name}: ${text}`);
      // The attempt must have been an attempt: a slip in the test's own program proves nothing.
      expect(text, name).not.toMatch(/SyntaxError|IndentationError|No module named 'numpy'/);
    }
  }
  expect(open).toEqual([]);
  expect(asked).toEqual([]);
  expect(await pageState()).toEqual(before);
});

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
