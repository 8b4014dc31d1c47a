/** Fetching with progress, and unpacking. Imports nothing of ours. */

export interface Download {
  url: string;
  /** Size as transferred, known from the build: a host need not say. */
  bytes: number;
}

/** Adds up several downloads into one progress. */
export class Progress extends EventTarget {
  total = 0;
  loaded = 0;

  expect(bytes: number): void {
    this.total += bytes;
    this.#changed();
  }

  add(bytes: number): void {
    this.loaded = Math.max(0, Math.min(this.total, this.loaded + bytes));
    this.#changed();
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}

/**
 * What `use` makes of a file's body, each piece counted as it arrives. What fails is done once more,
 * past every cache: what came may have been a damaged copy. Throws an Error that names the file.
 */
export async function fetchCounted<Result>(
  download: Download,
  progress: Progress,
  use: (body: Body) => Promise<Result>,
): Promise<Result> {
  const attempt = async (cache: RequestCache): Promise<Result> => {
    let counted = 0;
    const count = (bytes: number): void => {
      counted += bytes;
      progress.add(bytes);
    };
    try {
      return await use(await bodyOf(download.url, cache, count));
    } catch (error) {
      progress.add(-counted);
      throw error;
    }
  };
  try {
    return await attempt("default");
  } catch {
    // The next moment, or another copy, may be a better one.
  }
  try {
    return await attempt("reload");
  } catch (error) {
    if (error instanceof NotFetched) throw error;
    const why = error instanceof Error ? error.message : String(error);
    throw new Error(`${fileName(download.url)} did not arrive as it was published (${why})`);
  }
}

/** A server that sends nothing for so long has forgotten about it [ms]. */
const STALL_MS = 30_000;

type Body = ReadableStream<Uint8Array<ArrayBuffer>>;

/** A file that the network or the server does not give. */
class NotFetched extends Error {}

async function bodyOf(
  url: string,
  cache: RequestCache,
  count: (bytes: number) => void,
): Promise<Body> {
  let response: Response;
  const stalled = new AbortController();
  let patience: ReturnType<typeof setTimeout> | undefined;
  const wait = (): void => {
    clearTimeout(patience);
    patience = setTimeout(() => {
      stalled.abort(new NotFetched(`${fileName(url)} has stopped coming`));
    }, STALL_MS);
  };
  wait();
  try {
    response = await fetch(url, { cache, signal: stalled.signal });
  } catch (error) {
    clearTimeout(patience);
    if (error instanceof NotFetched) throw error;
    throw new NotFetched(`${fileName(url)} could not be fetched: is the network there?`);
  }
  if (!response.ok || !response.body) {
    clearTimeout(patience);
    throw new NotFetched(`${fileName(url)} could not be fetched: status ${response.status}`);
  }
  return response.body.pipeThrough(
    new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
      transform(piece, controller) {
        wait();
        count(piece.byteLength);
        controller.enqueue(piece);
      },
      flush() {
        clearTimeout(patience);
      },
    }),
  );
}

/** What `use` makes of the unpacked content of a gzipped file, as a Response. */
export function fetchUnpacked<Result>(
  download: Download,
  progress: Progress,
  use: (response: Response) => Promise<Result>,
  contentType = "application/octet-stream",
): Promise<Result> {
  return fetchCounted(download, progress, (packed) => {
    const stream = packed.pipeThrough(new DecompressionStream("gzip"));
    return use(new Response(stream, { headers: { "Content-Type": contentType } }));
  });
}

function fileName(url: string): string {
  return new URL(url).pathname.split("/").at(-1) ?? url;
}
