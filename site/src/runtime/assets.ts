/**
 * Everything that workers are handed, downloaded once a page.
 *
 * What the first run needs comes first; the standard library follows behind it, because the
 * snapshot already holds the modules that most programs use.
 */
import { base, files, loader, type PythonFile } from "virtual:python-files";
import { type Download, fetchCounted, fetchUnpacked, Progress } from "./download.ts";
import type { Boot } from "./messages.ts";

export class Assets {
  readonly progress = new Progress();
  readonly #module: Promise<WebAssembly.Module>;
  #snapshot: Promise<Blob | null>;
  readonly #sources: Promise<Record<string, Uint8Array>>;
  #stdlib: Promise<ArrayBuffer> | null = null;
  #stdlibBytes: ArrayBuffer | null = null;
  #numpy: Promise<ArrayBuffer> | null = null;
  #yaml: Promise<ArrayBuffer> | null = null;
  #judging: Promise<ArrayBuffer> | null = null;

  /** @param hindered why nothing is to be fetched: it could not be used. */
  constructor(hindered: string | null = null) {
    if (hindered !== null) {
      const nothing = Promise.reject(new Error(hindered));
      nothing.catch(() => {});
      this.#module = nothing;
      this.#snapshot = Promise.resolve(null);
      this.#sources = nothing;
      return;
    }
    for (const file of [files.interpreter, files.snapshot, files.sources]) {
      this.progress.expect(file.bytes);
    }
    this.#module = fetchUnpacked(
      download(files.interpreter),
      this.progress,
      (response) => WebAssembly.compileStreaming(response),
      "application/wasm",
    );
    this.#snapshot = this.#unpack(files.snapshot, (response) => response.blob()).catch(
      (error: unknown) => {
        note(error);
        return null;
      },
    );
    this.#sources = this.#unpack(files.sources, async (response) =>
      encoded((await response.json()) as Record<string, string>),
    );
    // Each is awaited in boot(); until then a failure is not "unhandled".
    for (const part of [this.#module, this.#snapshot, this.#sources]) part.catch(() => {});
  }

  /** What a new worker is handed now. Rejects if the site's files can't be had. */
  async boot(): Promise<Boot> {
    const [module, snapshot, sources] = await Promise.all([
      this.#module,
      this.#snapshot,
      this.#sources,
    ]);
    const stdlib = snapshot ? this.#stdlibBytes : await this.stdlib();
    return { kind: "boot", pyodideUrl: url(`${loader}/`), module, snapshot, stdlib, sources };
  }

  /** The standard library's archive; the download starts with the first call. */
  stdlib(): Promise<ArrayBuffer> {
    this.#stdlib ??= this.#bytes(files.stdlib, new Progress()).then((bytes) => {
      this.#stdlibBytes = bytes;
      return bytes;
    });
    // The next call tries again.
    this.#stdlib.catch(() => {
      this.#stdlib = null;
    });
    return this.#stdlib;
  }

  /** NumPy's wheel; `note` hears how far the download is. */
  numpy(note: (text: string) => void): Promise<ArrayBuffer> {
    const progress = new Progress();
    progress.expect(files.numpy.bytes);
    progress.addEventListener("change", () => {
      const percent = Math.round((100 * progress.loaded) / progress.total);
      note(`Loading NumPy: ${percent} % of ${(progress.total / 1e6).toFixed(1)} MB`);
    });
    this.#numpy ??= this.#bytes(files.numpy, progress);
    this.#numpy.catch(() => {
      this.#numpy = null;
    });
    return this.#numpy;
  }

  /** PyYAML's archive: 60 kB. */
  yaml(): Promise<ArrayBuffer> {
    this.#yaml ??= this.#bytes(files.yaml, new Progress());
    this.#yaml.catch(() => {
      this.#yaml = null;
    });
    return this.#yaml;
  }

  /** The judge and the reference mapper: for workers that run no learner's program. */
  judging(): Promise<ArrayBuffer> {
    this.#judging ??= this.#bytes(files.judging, new Progress());
    this.#judging.catch(() => {
      this.#judging = null;
    });
    return this.#judging;
  }

  /**
   * Start plainly from now on: slower, but it works. False if that is what was tried already.
   * @param error why the snapshot is of no use
   */
  async dropSnapshot(error: unknown): Promise<boolean> {
    if ((await this.#snapshot) === null) return false;
    note(error);
    this.#snapshot = Promise.resolve(null);
    return true;
  }

  #unpack<Result>(file: PythonFile, use: (response: Response) => Promise<Result>): Promise<Result> {
    return fetchUnpacked(download(file), this.progress, use);
  }

  #bytes(file: PythonFile, progress: Progress): Promise<ArrayBuffer> {
    return fetchCounted(download(file), progress, async (body) => {
      const bytes = await new Response(body).arrayBuffer();
      if (bytes.byteLength !== file.bytes) {
        throw new Error(`${bytes.byteLength} of ${file.bytes} bytes`);
      }
      return bytes;
    });
  }
}

function encoded(texts: Record<string, string>): Record<string, Uint8Array> {
  const encoder = new TextEncoder();
  return Object.fromEntries(
    Object.entries(texts).map(([path, text]) => [path, encoder.encode(text)]),
  );
}

function note(error: unknown): void {
  console.info("Python starts without its memory snapshot:", error);
}

function url(path: string): string {
  return new URL(base + path, import.meta.url).href;
}

function download(file: PythonFile): Download {
  return { url: url(file.path), bytes: file.bytes };
}
