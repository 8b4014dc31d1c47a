/** npm run dev: the instructor's server, which reloads the page when a file changes. PORT sets its port. */
import { join } from "node:path";
import { ROOT } from "./files.mjs";
import { ensureInstalled } from "./install.mjs";

ensureInstalled();
const { createServer } = await import("vite");
const server = await createServer({
  configFile: join(ROOT, "vite.config.js"),
  ...(process.env.PORT ? { server: { port: Number(process.env.PORT) } } : {}),
});
await server.listen();
server.printUrls();
