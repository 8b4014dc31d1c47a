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
    this.loaded = Math.min(this.total, this.loaded + bytes);
    this.#changed();
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}

/** The body of a file, each piece counted as it arrives. Throws an Error that names the file. */
export async function fetchCounted(
  download: Download,
  progress: Progress,
): Promise<ReadableStream<Uint8Array<ArrayBuffer>>> {
  let response: Response;
  try {
    response = await fetch(download.url);
  } catch {
    throw new Error(`${fileName(download.url)} could not be fetched: is the network there?`);
  }
  if (!response.ok || !response.body) {
    throw new Error(`${fileName(download.url)} could not be fetched: status ${response.status}`);
  }
  return response.body.pipeThrough(
    new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
      transform(piece, controller) {
        progress.add(piece.byteLength);
        controller.enqueue(piece);
      },
    }),
  );
}

/** The unpacked content of a gzipped file, as a Response, which turns into whatever is wanted. */
export async function fetchUnpacked(
  download: Download,
  progress: Progress,
  contentType = "application/octet-stream",
): Promise<Response> {
  const packed = await fetchCounted(download, progress);
  const stream = packed.pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream, { headers: { "Content-Type": contentType } });
}

function fileName(url: string): string {
  return new URL(url).pathname.split("/").at(-1) ?? url;
}
