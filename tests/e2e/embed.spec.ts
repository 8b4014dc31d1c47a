/** Labs in pages of other sites: by embed.js from another origin, and in a frame by hand. */
import { createServer, type Server } from "node:http";
import { test as base, expect, type FrameLocator } from "@playwright/test";
import type { Outcome } from "../../site/src/trace/events.ts";

interface HostLab extends HTMLElement {
  program: string;
  world: string;
  seed: number;
  run(): Promise<Outcome>;
  stop(): void;
  seek(seconds: number): void;
}

const PROGRAM = `from bugbot import *
print("in a frame")
forward(40, 20)
`;

/** A bare page of another origin, and what went wrong on it. */
const test = base.extend<{ host: (body: string) => Promise<void>; complaints: string[] }>({
  complaints: async ({ context, baseURL }, use) => {
    const complaints: string[] = [];
    context.on("console", (message) => {
      if (message.type() === "error") complaints.push(message.text());
    });
    context.on("weberror", (error) => complaints.push(error.error().message));
    context.on("request", (request) => {
      const { origin, hostname, protocol } = new URL(request.url());
      const known = origin === new URL(baseURL ?? "").origin || hostname === "localhost";
      if (!known && protocol !== "blob:") complaints.push(`request: ${request.url()}`);
    });
    await use(complaints);
    expect(complaints).toEqual([]);
  },

  host: async ({ page, complaints }, use) => {
    expect(complaints).toEqual([]);
    let html = "";
    const server = createServer((_request, response) => {
      response.writeHead(200, { "Content-Type": "text/html; charset=utf-8" }).end(html);
    });
    await new Promise<void>((resolve) => server.listen(0, () => resolve()));
    await use(async (body) => {
      html = `<!doctype html><html lang="en"><title>A school</title><link rel="icon" href="data:,">${body}</html>`;
      // Another host name as well as another port: another site for the browser.
      await page.goto(`http://localhost:${portOf(server)}/`);
    });
    server.closeAllConnections();
    server.close();
  },
});

function portOf(server: Server): number {
  const address = server.address();
  return typeof address === "object" && address ? address.port : 0;
}

const lab = (frame: FrameLocator) => ({
  run: frame.getByRole("button", { name: "Run", exact: true }),
  program: frame.getByRole("textbox", { name: "Program" }),
  console: frame.getByRole("log", { name: "Console" }),
  time: frame.getByRole("slider", { name: "Time" }),
  status: frame.getByRole("status", { name: "Status of the run" }),
});

test("one script and one tag make a lab in a page of another origin @once", async ({
  page,
  host,
  baseURL,
}) => {
  await host(`<h1>Week 3</h1>
    <script async src="${baseURL}embed.js"></script>
    <bugbot-lab world="wall-ahead" seed="7" label="Drive" theme="dark"><pre>
${PROGRAM}</pre></bugbot-lab>`);
  const { program, console, time, status, run } = lab(page.frameLocator("iframe"));
  await expect(program).toContainText("in a frame");
  await expect(page.frameLocator("iframe").getByRole("banner")).toHaveCount(0);
  const element = page.locator("bugbot-lab");
  const call = <Result>(action: (lab: HostLab) => Result | Promise<Result>): Promise<Result> =>
    element.evaluate(action as (node: Element) => Result | Promise<Result>) as Promise<Result>;

  const outcome = await call((lab) => lab.run());
  expect(outcome).toMatchObject({ status: "finished", console: "in a frame\n" });
  expect(outcome.pose.y).toBeGreaterThan(0);
  await expect(console).toContainText("in a frame");
  // It plays by itself to the end; from there one can go back.
  const { seconds } = outcome;
  await expect(time).toHaveAttribute("aria-valuetext", `${seconds.toFixed(1)} s`);
  await call((lab) => lab.seek(0.2));
  await expect(time).toHaveAttribute("aria-valuetext", /^0\.2 s/);

  // What is set is there for the run that follows; what the reader does is told.
  const changed = await call(async (lab) => {
    lab.world = "empty";
    lab.seed = 3;
    lab.program = "while True:\n    pass\n";
    const stopped = lab.run();
    setTimeout(() => lab.stop(), 1500);
    return [(await stopped).status, lab.world, lab.seed];
  });
  expect(changed).toEqual(["stopped", "empty", 3]);
  await program.focus();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.insertText("print('typed')\n");
  await expect.poll(() => call((lab) => lab.program)).toBe("print('typed')\n");
  await call((lab) => {
    lab.world = "no-such-world";
  });
  await expect(status).toContainText('There is no world "no-such-world" here.');

  // The frame is as high as the lab: nothing to scroll inside.
  await expect(run).toBeVisible();
  const room = await page.frames()[1]?.evaluate(() => {
    const { scrollHeight, dataset } = document.documentElement;
    return { over: scrollHeight - innerHeight, theme: dataset.theme };
  });
  expect(room).toEqual({ over: 0, theme: "dark" });
});

test("a lab that nobody sees keeps no interpreter, and runs all the same @once", async ({
  page,
  host,
  baseURL,
}) => {
  test.setTimeout(150_000);
  // Browsers hold up the timers of a frame that is out of sight.
  const OUT_OF_SIGHT = { timeout: 45_000 };
  await host(`<script async src="${baseURL}embed.js"></script>
    <bugbot-lab world="empty"><pre>print("it ran")</pre></bugbot-lab>
    <div style="height: 20000px"></div><p id="below">Below</p>`);
  const { program } = lab(page.frameLocator("iframe"));
  await expect(program).toBeVisible();
  const workers = () => page.workers().length;
  await expect.poll(workers).toBe(1);
  await page.locator("#below").scrollIntoViewIfNeeded();
  await expect.poll(workers, OUT_OF_SIGHT).toBe(0);
  const run = () => page.locator("bugbot-lab").evaluate((element) => (element as HostLab).run());
  expect((await run()).console).toBe("it ran\n");
  await expect.poll(workers, OUT_OF_SIGHT).toBe(0);
  // Seen again, it has one ready as before.
  await page.locator("bugbot-lab").scrollIntoViewIfNeeded();
  await expect.poll(workers).toBe(1);
});

test("?embed is a page for a frame: no header, no footer, a lab that fits @once", async ({
  page,
  host,
  baseURL,
}) => {
  await host(`<iframe title="Lab" width="1100" height="650"
    src="${baseURL}lab/?embed&world=empty&seed=5&name=one&theme=light"></iframe>`);
  const frame = page.frameLocator("iframe");
  const { program } = lab(frame);
  await expect(program).toBeVisible();
  await expect(frame.getByRole("banner")).toHaveCount(0);
  await expect(frame.getByRole("contentinfo")).toHaveCount(0);
  await expect(frame.getByRole("textbox", { name: "Seed" })).toHaveValue("5");
  await expect(frame.getByRole("combobox", { name: "World" })).toHaveCount(0);
  const inside = await page.frames()[1]?.evaluate(() => ({
    over: document.documentElement.scrollHeight - innerHeight,
    theme: document.documentElement.dataset.theme,
  }));
  expect(inside).toEqual({ over: 0, theme: "light" });
});
