/**
 * A thread that starts Python plainly, runs one piece of code, and ends: beside the snapshot, which takes
 * as long to make. Answers with the text that the code comes to.
 */
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";
import { runInPyodide } from "./snapshot.mjs";

/**
 * @param {Record<string, string>} sources path below site-packages -> text
 * @param {string} code
 * @returns {Promise<string>}
 */
export function runInThread(sources, code) {
  return new Promise((resolve, reject) => {
    const thread = new Worker(new URL(import.meta.url), {
      workerData: { once: { sources, code } },
    });
    thread.once("message", resolve);
    thread.once("error", reject);
  });
}

const once = isMainThread ? null : workerData?.once;
if (once) parentPort?.postMessage(await runInPyodide(once.sources, once.code));
