/** Devices and browsers that give little: what works still works, and what can't is said. */
import { expect, test } from "./fixtures.ts";

const BLOCKED: Record<string, [fake: () => void, said: string]> = {
  "WebAssembly is switched off": [
    () => Reflect.deleteProperty(globalThis, "WebAssembly"),
    "Python could not start: it needs WebAssembly, which is switched off in this browser",
  ],
  "there are no workers": [
    () => Reflect.deleteProperty(globalThis, "Worker"),
    "Python could not start: it needs a worker, and this browser does not let pages start any",
  ],
  "workers are refused": [
    () => {
      globalThis.Worker = class {
        constructor() {
          throw new DOMException("refused", "SecurityError");
        }
      } as unknown as typeof Worker;
    },
    "Python could not start: it needs a worker, and this browser does not let pages start any",
  ],
  "memory has run out": [
    () => {
      WebAssembly.compileStreaming = () =>
        Promise.reject(new RangeError("WebAssembly.Memory(): could not allocate memory"));
    },
    "too little memory",
  ],
};

for (const [what, [fake, said]] of Object.entries(BLOCKED)) {
  test(`where ${what} the page says so, and the program can be written @once`, async ({
    page,
    app,
  }) => {
    await page.addInitScript(fake);
    await app.openLab("world=empty");
    await app.write("print('mine')\n");
    await app.run.click();
    await expect(app.status).toContainText(said);
    await expect(page.getByRole("button", { name: "Try again" })).toBeVisible();
    await page.reload();
    await expect(app.program).toBeVisible();
    expect(await app.text()).toBe("print('mine')\n");
  });
}

test("a device with little memory starts Python for the first run, and one interpreter at a time @once", async ({
  page,
  app,
}) => {
  await page.addInitScript(() => {
    Object.defineProperty(Navigator.prototype, "deviceMemory", { value: 2 });
    const counts = { now: 0, most: 0, ever: 0 };
    Object.assign(globalThis, { counts });
    globalThis.Worker = class extends Worker {
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options);
        counts.ever += 1;
        counts.now += 1;
        counts.most = Math.max(counts.most, counts.now);
      }

      override terminate(): void {
        counts.now -= 1;
        super.terminate();
      }
    };
  });
  // Workers are made in a frame of the page's; those of all its documents are counted.
  const counts = async () => {
    const each = await Promise.all(
      page.frames().map((frame) => frame.evaluate<Record<string, number>>("({ ...counts })")),
    );
    const sum = (name: string) => each.reduce((total, one) => total + (one[name] ?? 0), 0);
    return { now: sum("now"), most: sum("most"), ever: sum("ever") };
  };
  await app.openLab("world=empty");
  // Somebody reads and writes: elsewhere Python would be on its way by now.
  await app.write("from bugbot import *\nfor _ in range(30):\n    forward(5)\nprint('done')\n");
  await expect(app.status).toContainText("Press Run to start Python and the robot.");
  expect(await counts()).toEqual({ now: 0, most: 0, ever: 0 });
  for (const _ of [1, 2]) {
    await app.run.click();
    await app.ended();
    await expect(app.console).toContainText("done");
  }
  await expect.poll(counts).toMatchObject({ most: 1 });
});

test("where a page may not even ask for storage everything else works, and it says so @once", async ({
  page,
  app,
}) => {
  await page.addInitScript(() => {
    for (const name of ["localStorage", "sessionStorage"]) {
      Object.defineProperty(globalThis, name, {
        get: () => {
          throw new DOMException("The operation is insecure.", "SecurityError");
        },
      });
    }
  });
  await app.openLab("world=empty");
  await app.write("print('not kept')\n");
  await expect(app.status).toContainText("does not let the site keep your program");
  await app.run.click();
  await expect(app.console).toContainText("not kept");
});
