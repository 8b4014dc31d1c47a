/** What the processes of a browser take of memory. Imports Node's own modules only. */
import { readFileSync } from "node:fs";

/**
 * The memory that is really used by all of them together [bytes], shared pages counted once; null where
 * the system does not say.
 * @param {import("@playwright/test").Browser} browser a Chromium
 * @returns {Promise<number | null>}
 */
export async function processMemory(browser) {
  const devtools = await browser.newBrowserCDPSession();
  const { processInfo } = await devtools.send("SystemInfo.getProcessInfo");
  await devtools.detach();
  let sum = 0;
  for (const { id } of processInfo) {
    try {
      const kilobytes = /^Pss:\s+(\d+) kB/m.exec(readFileSync(`/proc/${id}/smaps_rollup`, "utf8"));
      sum += Number(kilobytes?.[1] ?? 0) * 1000;
    } catch {
      // It has ended, or this is no Linux.
    }
  }
  return sum || null;
}
