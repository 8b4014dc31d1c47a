/**
 * npm run typing [-- PART-OF-A-NAME …]: types the learner's part of every solution, and the article's
 * programs, into the lab of the built site, key by key and with the completion list at work. What
 * stands there must be what was typed. All at 30 ms a key, the twelve shortest at 120 ms as well.
 */
import { build } from "../../site/build/build.mjs";

const FAST_MS = 30;
const SLOW_MS = 120;
const SLOW = 12;

if (!process.argv.includes("--built")) await build();
const { chromium } = await import("@playwright/test");
const { launchOptions } = await import("../browser.mjs");
const { ensureBrowser } = await import("../setup.mjs");
const { serve } = await import("../bench/server.mjs");
const { parting, pieces, typePiece } = await import("./typist.mjs");
ensureBrowser();

const wanted = process.argv.slice(2).filter((word) => !word.startsWith("--"));
const all = pieces().filter(
  ({ name }) => wanted.length === 0 || wanted.some((word) => name.includes(word)),
);
const slow = [...all].sort((a, b) => a.typed.length - b.typed.length).slice(0, SLOW);
const work = [
  ...all.map((piece) => ({ piece, delay: FAST_MS })),
  ...slow.map((piece) => ({ piece, delay: SLOW_MS })),
];

const start = Date.now();
const server = await serve();
const browser = await chromium.launch(launchOptions());
let keys = 0;
let wrong = 0;
/** Two typists: a typist waits for most of the time. */
await Promise.all([typist(), typist()]);
await browser.close();
server.close();
const seconds = Math.round((Date.now() - start) / 1000);
console.log(
  `${all.length} programs typed at ${FAST_MS} ms a key, ${slow.length} of them at ${SLOW_MS} ms as well: ` +
    `${keys} keys in ${seconds} s; ${wrong === 0 ? "all as typed" : `${wrong} are not as typed`}`,
);
process.exitCode = wrong === 0 && all.length > 0 ? 0 : 1;

async function typist() {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  for (let next = work.shift(); next; next = work.shift()) {
    const { piece, delay } = next;
    await page.goto(`${server.url}/site/lab/?world=empty`);
    const there = await typePiece(page, piece, delay);
    const parts = parting(piece.before + piece.typed + piece.after, there);
    keys += piece.typed.length;
    if (parts !== null) wrong++;
    console.log(`${piece.name}, ${piece.typed.length} keys at ${delay} ms: ${parts ?? "as typed"}`);
  }
  await page.close();
}
