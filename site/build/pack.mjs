/**
 * npm run pack: the built site as one ZIP archive that works from a USB stick, with a short READ-ME.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { build } from "./build.mjs";
import { filesBelow, ROOT } from "./files.mjs";
import { zip } from "./zip.mjs";

/** The folder that the archive unpacks to. */
const FOLDER = "bugbot-lessons";

/** Lines end as Windows' own editor wants them; the others take both. */
const READ_ME = `bugbot lessons: occupancy grid mapping with programs that run

The folder "site" is the whole web site. It needs no network, but a web server,
because browsers do not run Python from a file that is merely opened. If this
computer has Python 3, that is one command, in the folder of this file:

  Windows         py -m http.server 8000 --bind 127.0.0.1 --directory site
  macOS, Linux    python3 -m http.server 8000 --bind 127.0.0.1 --directory site

Then open http://127.0.0.1:8000/ in a browser. Ctrl-C ends the server.

Any other web server does as well: let it serve the folder "site", as it is, from
whatever address. On your own computer the pages can also be kept in the browser
("Use offline" at the foot of every page). From a server of the school that takes
an address that begins with https.

If the text is there but no lab appears, the server calls .js and .mjs files
something else than text/javascript. Some Windows computers are set up like that;
another computer or another server helps.
`.replaceAll("\n", "\r\n");

/**
 * The archive of a built site.
 * @param {string} site its folder
 * @returns {Buffer}
 */
export function packed(site) {
  const files = filesBelow(site).map((path) => ({
    path: `${FOLDER}/site/${path}`,
    data: readFileSync(join(site, path)),
  }));
  return zip([{ path: `${FOLDER}/READ-ME.txt`, data: Buffer.from(READ_ME) }, ...files]);
}

if (process.argv[1] === import.meta.filename) {
  await build();
  const { version } = JSON.parse(readFileSync(join(ROOT, "package.json"), "utf8"));
  const name = `${FOLDER}-${version}.zip`;
  const archive = packed(join(ROOT, "dist"));
  writeFileSync(join(ROOT, name), archive);
  console.log(`packed: ${name}, ${(archive.length / 1e6).toFixed(1)} MB`);
}
