/** npm run dev: the instructor's server, which reloads the page when a file changes. PORT sets its port. */
import { ensureInstalled } from "./install.mjs";

ensureInstalled();
const { createServer } = await import("vite");
const server = await createServer({
  configFile: new URL("../../vite.config.js", import.meta.url).pathname,
  ...(process.env.PORT ? { server: { port: Number(process.env.PORT) } } : {}),
});
await server.listen();
server.printUrls();
