/**
 * What every story starts from: the app, and a watch over the page. A story fails if the page logs
 * an error, throws one, or asks anything of another site.
 */
import { test as base, expect } from "@playwright/test";
import { App } from "./app.ts";

export { expect };

export const test = base.extend<{ app: App; complaints: string[] }>({
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
