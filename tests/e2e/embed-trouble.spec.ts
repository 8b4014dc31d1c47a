/**
 * A lab in another site's page, where something goes wrong or the page asks for nonsense: each run() comes
 * to an outcome, or to an error that says why.
 */
import { createServer, type ServerResponse } from "node:http";
import { test as base, expect, type Page } from "@playwright/test";
import type { Outcome } from "../../site/src/trace/events.ts";
import { FailingServer } from "../loading/failing-server.mjs";
import { DIST } from "./own-site.ts";

interface HostLab extends HTMLElement {
  program: unknown;
  world: unknown;
  seed: unknown;
  run(): Promise<Outcome>;
  stop(): void;
  seek(seconds: unknown): void;
}

type Settled = { outcome: Outcome } | { error: string };

/** A site of its own whose files can be made to fail, and a page of another site around its lab. */
const test = base.extend<{
  site: FailingServer;
  host: (body: string, second?: string) => Promise<void>;
}>({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright asks for the braces
  site: async ({}, use) => {
    const site = await new FailingServer(DIST).listen();
    await use(site);
    site.close();
  },

  host: async ({ page }, use) => {
    let pieces: string[] = [];
    const waiting: ServerResponse[] = [];
    const server = createServer((request, response) => {
      if (request.url === "/go-on") {
        for (const open of waiting.splice(0)) open.end(pieces[1]);
        response.end();
        return;
      }
      response.writeHead(200, { "Content-Type": "text/html; charset=utf-8" });
      response.write(`<!doctype html><html lang="en"><link rel="icon" href="data:,">${pieces[0]}`);
      if (pieces.length > 1) waiting.push(response);
      else response.end();
    });
    await new Promise<void>((resolve) => server.listen(0, () => resolve()));
    const address = server.address();
    const port = typeof address === "object" && address ? address.port : 0;
    await use(async (...given) => {
      pieces = given.filter((piece) => piece !== undefined);
      // Another host name as well as another port: another site for the browser.
      await page.goto(`http://localhost:${port}/`, { waitUntil: "commit" });
    });
    server.closeAllConnections();
    server.close();
  },
});

const tag = (site: FailingServer, inside = "<pre>print('as given')</pre>") =>
  `<script src="${site.url}embed.js"></script><bugbot-lab world="empty">${inside}</bugbot-lab>`;

/** What becomes of a run; `before` is done first. */
async function run(page: Page, before: (lab: HostLab) => void = () => {}): Promise<Settled> {
  return page.locator("bugbot-lab").evaluate(async (element, action) => {
    const lab = element as HostLab;
    new Function("lab", `return (${action})(lab)`)(lab);
    return lab.run().then(
      (outcome) => ({ outcome }),
      (error: unknown) => ({ error: String(error) }),
    );
  }, before.toString()) as Promise<Settled>;
}

const AS_GIVEN = { outcome: { status: "finished", console: "as given\n" } };

test("what a program, a world or a seed can't be is refused in words; of 500 runs each settles @once", async ({
  page,
  site,
  host,
}) => {
  await host(tag(site));
  // Before there is a lab to say it.
  expect(
    await run(page, (lab) => {
      lab.program = 5;
    }),
  ).toMatchObject(AS_GIVEN);
  const status = page.frameLocator("iframe").getByRole("status", { name: "Status of the run" });
  const nonsense: [before: (lab: HostLab) => void, said: string][] = [
    [(lab) => Object.assign(lab, { program: {} }), "given an object as its program"],
    [(lab) => Object.assign(lab, { program: () => {} }), "given a function as its program"],
    [(lab) => Object.assign(lab, { program: null }), "given null as its program"],
    [(lab) => Object.assign(lab, { seed: Number.NaN }), "given NaN as its seed"],
    [(lab) => Object.assign(lab, { seed: 1e300 }), "as its seed; it takes a whole number"],
    [(lab) => Object.assign(lab, { world: 7 }), "given 7 as its world"],
    [(lab) => lab.seek("soon"), "given a string as its seek"],
  ];
  for (const [before, said] of nonsense) {
    await page
      .locator("bugbot-lab")
      .evaluate((lab, action) => new Function("lab", `(${action})(lab)`)(lab), before.toString());
    await expect(status).toContainText(said);
  }
  expect(await run(page)).toMatchObject(AS_GIVEN);

  // 500 times run and stop: each run settles, and the newest counts.
  const outcomes = await page.locator("bugbot-lab").evaluate(async (element) => {
    const lab = element as HostLab;
    const runs: Promise<Outcome>[] = [];
    for (let i = 0; i < 500; i++) {
      runs.push(lab.run());
      lab.stop();
    }
    runs.push(lab.run());
    return (await Promise.all(runs)).map(({ status, console }) => `${status} ${console}`);
  });
  expect(outcomes.length).toBe(501);
  expect(outcomes.at(-1)).toBe("finished as given\n");
  expect(new Set(outcomes.slice(0, -1))).toEqual(new Set(["stopped "]));
});

test("a page that speaks with the lab by itself may say anything @once", async ({
  page,
  site,
  host,
}) => {
  await host(`<iframe src="${site.url}lab/?embed=host" style="width: 100%; height: 700px"></iframe>
    <script>
      const frame = document.querySelector("iframe");
      window.heard = [];
      addEventListener("message", ({ data }) => {
        if (data !== "bugbot-lab: hello") return;
        const { port1, port2 } = new MessageChannel();
        window.port = port1;
        port1.onmessage = ({ data }) => heard.push(data);
        frame.contentWindow.postMessage(null, "*");
        frame.contentWindow.postMessage(
          { kind: "bugbot-lab: hello", start: { program: 5, world: {}, seed: [], pickers: "no" } }, "*", [port2]);
        for (const odd of [null, 5, "run", {}, { kind: "set" }, { kind: "set", state: null },
          { kind: "set", state: { program: [] } }, { kind: "run" }, { kind: "run", id: {} },
          { kind: "seek" }, { kind: "wrong", what: "toString", got: {} }]) port1.postMessage(odd);
        port1.postMessage({ kind: "set", state: { program: "print('sense')" } });
        port1.postMessage({ kind: "run", id: 17 });
      });
    </script>`);
  await expect
    .poll(() => page.evaluate("heard.find(({ kind }) => kind === 'outcome')"), { timeout: 45_000 })
    .toMatchObject({ id: 17, outcome: { console: "sense\n" } });
});

test("where the lab's page fails, run() says so, and works once the page is there @once", async ({
  page,
  site,
  host,
}) => {
  const main = "assets/main-";
  const failures = [
    ["503", "lab/index.html", "did not answer with a lab"],
    ["404", main, "Part of this page didn’t load"],
  ] as const;
  for (const [failure, path, why] of failures) {
    const file = path === main ? await mainScript() : path;
    site.fault = { path: file, failure, times: 1000 };
    await host(tag(site));
    const settled = await run(page);
    expect(settled, `${failure} of ${file}`).toHaveProperty("error");
    expect("error" in settled && settled.error).toMatch(new RegExp(why));
    site.fault = null;
    expect(await run(page), `after ${failure} of ${file}`).toMatchObject(AS_GIVEN);
  }
});

async function mainScript(): Promise<string> {
  const { filesBelow } = await import("../../site/build/files.mjs");
  return filesBelow(DIST).find((path) => /^assets\/main-.*\.js$/.test(path)) ?? "";
}

test("a lab's page that never answers, or breaks off: run() gives up, and says so @once", async ({
  page,
  site,
  host,
}) => {
  await page.clock.install();
  for (const failure of ["hang", "cut"] as const) {
    site.fault = { path: "lab/index.html", failure, times: 1000 };
    await host(tag(site));
    await expect(page.locator("iframe")).toBeAttached();
    // The clock goes on when the lab has begun to wait, and not before.
    const settled = await page
      .locator("bugbot-lab")
      .evaluateHandle((lab) => ({ said: (lab as HostLab).run().then(String, String) }));
    await page.clock.fastForward(30_000);
    expect(await settled.evaluate(({ said }) => said)).toBe(
      `Error: <bugbot-lab>: ${site.url}lab/ has not answered for 20 s`,
    );
  }
});

test("the lab's page is loaded anew, left or taken away while a program runs @once", async ({
  page,
  site,
  host,
}) => {
  await host(tag(site, "<pre>while True:\n    pass</pre>"));
  const leave = [
    () => page.frames()[1]?.evaluate(() => location.reload()),
    () =>
      page.locator("iframe").evaluate((frame: HTMLIFrameElement) => {
        frame.src = "about:blank";
      }),
  ];
  const running = page.frameLocator("iframe").getByRole("button", { name: "Stop", exact: true });
  for (const go of leave) {
    const settled = run(page);
    await expect(running).toBeEnabled({ timeout: 45_000 });
    await go();
    expect(await settled).toMatchObject({
      error: expect.stringContaining("was left or loaded anew while the program was running"),
    });
  }
  const settled = page.locator("bugbot-lab").evaluate(async (element) => {
    const runs = (element as HostLab).run().catch(String);
    element.remove();
    return runs;
  });
  expect(await settled).toContain("it was taken out of the page");
});

test("a lab far down a page runs before anybody has seen it @once", async ({
  page,
  site,
  host,
}) => {
  await host(`<div style="height: 30000px"></div>${tag(site)}`);
  await expect(page.locator("iframe")).toBeAttached();
  expect(await run(page)).toMatchObject(AS_GIVEN);
});

test("embed.js may be there before its tag, and the tag may come in two pieces @once", async ({
  page,
  site,
  host,
}) => {
  const [first, second] = ["<pre>print('first')\n", "print('second')</pre>"];
  await host(
    `<script src="${site.url}embed.js"></script><bugbot-lab world="empty"><p>A lab</p>${first}`,
    `${second}</bugbot-lab><p>The end</p>`,
  );
  await page.waitForFunction(() => customElements.get("bugbot-lab"));
  await expect(page.getByText("A lab")).toBeVisible();
  await page.evaluate(() => fetch("/go-on"));
  await expect(page.getByText("The end")).toBeVisible();
  expect(await run(page)).toMatchObject({ outcome: { console: "first\nsecond\n" } });
  await expect(page.locator("bugbot-lab > *")).toHaveCount(1);
});
