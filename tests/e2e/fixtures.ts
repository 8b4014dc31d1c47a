/**
 * What every story starts from: the app, and a watch over the page. A story fails if the page logs
 * an error, throws one, or asks anything of another site.
 *
 * On a `small` device Python starts for the first run and not before, and none waits for the next run.
 * Stories that hardly run anything are told there: the starts are most of what they would take.
 */
import { test as base, expect } from "@playwright/test";
import { App } from "./app.ts";

export { expect };

export const test = base.extend<{ app: App; complaints: string[]; device: "usual" | "small" }>({
  device: ["usual", { option: true }],

  context: async ({ context, device }, use) => {
    if (device === "small") {
      await context.addInitScript(() => {
        Object.defineProperty(Navigator.prototype, "deviceMemory", { value: 2 });
      });
    }
    await use(context);
  },

  complaints: [
    async ({ page, baseURL }, use) => {
      const complaints: string[] = [];
      const home = new URL(baseURL ?? "").origin;
      page.on("console", (message) => {
        if (message.type() === "error") complaints.push(`console: ${message.text()}`);
      });
      page.on("pageerror", (error) => complaints.push(`page: ${error.message}`));
      page.on("request", (request) => {
        const { origin, protocol } = new URL(request.url());
        const local = origin === home || protocol === "blob:" || protocol === "data:";
        if (!local) complaints.push(`request: ${request.url()}`);
      });
      await use(complaints);
      expect(complaints, "what the page complained of").toEqual([]);
    },
    { auto: true },
  ],

  app: async ({ page }, use) => {
    await use(new App(page));
  },
});
