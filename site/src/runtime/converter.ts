/**
 * A question to the site's own Python, answered by an interpreter of its own: JSON in and out,
 * `py/bridge/ros.py` does the work. No program has been near that interpreter. Fetched when the
 * first question is asked.
 */
import { type ModuleFiles, provideModules } from "./modules.ts";
import type { Workers } from "./pool.ts";

/** The largest map takes some seconds; after this it is our fault [s]. */
const LONGEST_S = 60;
/** What the work imports that is not in every interpreter. */
const IMPORTS = "import zipfile";

/** Rejects if Python can't be had, breaks down or takes too long; that is never the reader's fault. */
export async function convert(
  request: string,
  workers: Workers,
  files: ModuleFiles,
): Promise<string> {
  const partner = await workers.take();
  // The next one starts while this one works; a failure shows when it is needed.
  workers.prepare().catch(() => {});
  try {
    const died = await provideModules(partner, IMPORTS, files, () => {});
    if (died) throw new Error(died.message);
    return await new Promise<string>((resolve, reject) => {
      const late = () => reject(new Error(`this took longer than ${LONGEST_S} s`));
      setTimeout(late, LONGEST_S * 1000);
      partner.listen((answer) => {
        if (answer.kind === "converted") resolve(answer.answer);
        else reject(new Error(answer.kind === "died" ? answer.message : `heard "${answer.kind}"`));
      });
      partner.send({ kind: "convert", id: 0, request });
    });
  } finally {
    partner.end();
  }
}
