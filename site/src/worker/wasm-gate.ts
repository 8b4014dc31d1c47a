/**
 * Decides which bytes may become WebAssembly. The loader gives a library every function of the
 * interpreter that it names, so a library written by a program could call functions that Python can't
 * reach. Only two kinds pass: the loader's small modules, each of which wraps a single function, and
 * the libraries of packages that the page has sent. Imports nothing of ours.
 */

/** The loader's own modules are no larger than this [bytes]. */
const SMALL_MODULE = 100;

export class WasmGate {
  #compiled = new Map<string, WebAssembly.Module>();
  #libraries: Uint8Array[] = [];
  #closed = false;

  /**
   * Replaces `WebAssembly.Module`. The loader makes 260 small modules, one for each of its functions
   * that Python may call, but only a dozen differ: one that has been compiled is used again.
   */
  install(): void {
    const make = (Module: typeof WebAssembly.Module, bytes: unknown) => this.#make(Module, bytes);
    WebAssembly.Module = new Proxy(WebAssembly.Module, {
      construct: (Module, [bytes]: unknown[]) => make(Module, bytes),
    });
  }

  /** From now on, compile only small modules and libraries passed to `expect`. */
  close(): void {
    this.#closed = true;
  }

  /** Allow a library of a package that the page has sent. */
  expect(library: Uint8Array): void {
    this.#libraries.push(library);
  }

  #make(Module: typeof WebAssembly.Module, given: unknown): WebAssembly.Module {
    // A copy, so that the bytes compiled are the bytes checked.
    const bytes = copyOf(given);
    if (bytes.length > SMALL_MODULE) {
      if (this.#closed && !this.#libraries.some((library) => isSame(library, bytes))) {
        throw new WebAssembly.CompileError("This library is not one of the site's");
      }
      return new Module(bytes);
    }
    const key = bytes.join();
    const module = this.#compiled.get(key) ?? new Module(bytes);
    this.#compiled.set(key, module);
    return module;
  }
}

function copyOf(given: unknown): Uint8Array<ArrayBuffer> {
  if (given instanceof ArrayBuffer) return new Uint8Array(given.slice());
  if (!ArrayBuffer.isView(given)) throw new TypeError("A module is made of bytes");
  const { buffer, byteOffset, byteLength } = given;
  return new Uint8Array(new Uint8Array(buffer, byteOffset, byteLength));
}

function isSame(one: Uint8Array, other: Uint8Array): boolean {
  return one.length === other.length && one.every((byte, i) => byte === other[i]);
}
