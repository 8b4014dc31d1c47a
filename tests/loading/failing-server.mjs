/**
 * A plain static host of which one file fails, in one of these ways, so many times.
 *
 * @typedef {"500" | "503" | "404" | "cut" | "wrong" | "hang"} Failure  `cut` breaks off in the middle;
 *   `wrong` is a page that says sorry in place of the file, with status 200; `hang` never answers
 * @typedef {{ path: string, failure: Failure, times: number }} Fault
 */
import { existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";

const FOLDER = "/some/school/";

/** @type {Record<string, string>} */
const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
  ".png": "image/png",
};

export const SORRY_TITLE = "Sorry";
const SORRY = `<!doctype html><html lang=en><title>${SORRY_TITLE}</title><p>Something went wrong.</p></html>`;

export class FailingServer {
  url = "";
  /** Every file that was asked for, by its path below the site. @type {Set<string>} */
  asked = new Set();
  /** @type {Fault | null} */
  fault = null;
  #dist;
  #server;

  /** @param {string} dist the built site */
  constructor(dist) {
    this.#dist = dist;
    this.#server = createServer((request, response) => {
      const { pathname } = new URL(request.url ?? "/", "http://localhost");
      const path = decodeURIComponent(pathname).slice(FOLDER.length);
      this.#answer(path.endsWith("/") || path === "" ? `${path}index.html` : path, response);
    });
  }

  /** @returns {Promise<this>} */
  listen() {
    return new Promise((resolve) => {
      this.#server.listen(0, "127.0.0.1", () => {
        const address = this.#server.address();
        const port = typeof address === "object" && address ? address.port : 0;
        this.url = `http://127.0.0.1:${port}${FOLDER}`;
        resolve(this);
      });
    });
  }

  close() {
    this.#server.closeAllConnections();
    this.#server.close();
  }

  /** @param {string} path @param {import("node:http").ServerResponse} response */
  #answer(path, response) {
    const file = join(this.#dist, path);
    if (path.includes("..") || !existsSync(file) || statSync(file).isDirectory()) {
      response.writeHead(404, { "Content-Type": "text/plain" }).end("not found");
      return;
    }
    this.asked.add(path);
    const data = readFileSync(file);
    const type = TYPES[extname(file)] ?? "application/octet-stream";
    const head = { "Content-Type": type, "Content-Length": data.length };
    if (this.fault?.path === path && this.fault.times > 0) {
      this.fault.times -= 1;
      this.#fail(this.fault.failure, response, head, data);
    } else response.writeHead(200, head).end(data);
  }

  /**
   * @param {Failure} failure @param {import("node:http").ServerResponse} response
   * @param {import("node:http").OutgoingHttpHeaders} head @param {Buffer} data
   */
  #fail(failure, response, head, data) {
    if (failure === "hang") return;
    if (failure === "cut") {
      response.writeHead(200, head);
      response.write(data.subarray(0, data.length >> 1), () => response.destroy());
    } else if (failure === "wrong") {
      response.writeHead(200, { "Content-Type": "text/html" }).end(SORRY);
    } else {
      response.writeHead(Number(failure), { "Content-Type": "text/plain" }).end("sorry");
    }
  }
}
