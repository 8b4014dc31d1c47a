/**
 * The plainest static host there is, for the tests: dist/ below a folder, no special headers, no
 * compression, no redirects but the one to a folder's slash.
 *
 * node tests/static-server.mjs [PORT [FOLDER-OF-THE-ADDRESS [FOLDER-OF-THE-SITE [tell]]]]
 *
 * PORT 0 is any free one. Prints the address once it answers and, if it is to tell, what it is asked for.
 */
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, resolve } from "node:path";
import { ROOT } from "../site/build/files.mjs";

const port = Number(process.argv[2] ?? 4174);
const prefix = process.argv[3] ?? "/some/school/";
const dist = resolve(process.argv[4] ?? join(ROOT, "dist"));
const tells = process.argv[5] === "tell";

/** @type {Record<string, string>} */
const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".png": "image/png",
};

const server = createServer((request, response) => {
  if (tells) console.log(request.url);
  const { pathname } = new URL(request.url ?? "/", "http://localhost");
  const path = decodeURIComponent(pathname);
  const inside = path.startsWith(prefix) && !path.includes("..");
  let file = join(dist, path.slice(prefix.length));
  if (inside && existsSync(file) && statSync(file).isDirectory()) {
    if (!path.endsWith("/")) return response.writeHead(301, { Location: `${path}/` }).end();
    file = join(file, "index.html");
  }
  if (!inside || !existsSync(file)) {
    return response.writeHead(404, { "Content-Type": "text/plain" }).end("not found");
  }
  response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "application/octet-stream" });
  return createReadStream(file).pipe(response);
});
server.listen(port, "127.0.0.1", () => {
  const address = server.address();
  const bound = typeof address === "object" && address ? address.port : port;
  console.log(`http://127.0.0.1:${bound}${prefix}`);
});
