/**
 * A question to the site's own Python, answered by an interpreter of its own: JSON and bytes in and
 * out, `py/bridge/ros.py` does the work. No program has been near that interpreter. Fetched when the
 * first question is asked.
 */
import type { Assets } from "./assets.ts";
import type { Workers } from "./pool.ts";

/** The largest map takes some seconds; after this it is our fault [s]. */
const LONGEST_S = 60;

export interface Converted {
  answer: string;
  /** Beside the answer, if there are some. */
  bytes: ArrayBuffer | null;
}

/** Rejects if Python can't be had, breaks down or takes too long; that is never the reader's fault. */
export async function convert(
  request: string,
  files: readonly ArrayBuffer[],
  workers: Workers,
  assets: Pick<Assets, "stdlib" | "yaml" | "judging">,
): Promise<Converted> {
  const [partner, stdlib, yaml, judging] = await Promise.all([
    workers.take(),
    assets.stdlib(),
    assets.yaml(),
    assets.judging(),
  ]);
  // The next one starts while this one works; a failure shows when it is needed.
  if (!workers.oneAtATime) workers.prepare().catch(() => {});
  try {
    // It does these in order, and leaves out what it has already.
    partner.send({ kind: "stdlib", bytes: stdlib });
    partner.send({ kind: "package", name: "yaml", bytes: yaml });
    partner.send({ kind: "package", name: "judging", bytes: judging });
    return await new Promise<Converted>((resolve, reject) => {
      const late = () => reject(new Error(`this took longer than ${LONGEST_S} s`));
      setTimeout(late, LONGEST_S * 1000);
      partner.listen((answer) => {
        if (answer.kind === "converted") resolve(answer);
        else reject(new Error(answer.kind === "died" ? answer.message : `heard "${answer.kind}"`));
      });
      partner.send({ kind: "convert", id: 0, request, files });
    });
  } finally {
    partner.end();
  }
}
