/**
 * Decides which bytes may become WebAssembly. The loader gives a library every function of the
 * interpreter that it names, so a library written by a program could call functions that Python can't
 * reach. Only two kinds pass: the loader's small modules, each of which wraps a single function, and
 * the libraries of packages that the page has sent. A small module is known by its bytes: whatever else
 * is small is a library too, since 90 bytes are enough for one. Imports nothing of ours.
 */

/** The loader's own modules are no larger than this [bytes]. */
const SMALL_MODULE = 100;

/** The magic number and the version, and the first section: the type of one function. */
const BEGINNING = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1];

/** All that follows the type: the function "f" of "e" is imported, and exported as "f". */
const ENDING = [2, 7, 1, 1, 0x65, 1, 0x66, 0, 0, 7, 5, 1, 1, 0x66, 0, 0];

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
    if (this.#closed && !wrapsOneFunction(bytes)) {
      if (!this.#libraries.some((library) => isSame(library, bytes))) {
        throw new WebAssembly.CompileError("This library is not one of the site's");
      }
      return new Module(bytes);
    }
    if (bytes.length > SMALL_MODULE) return new Module(bytes);
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

/** Whether it is a type of a function and a wrapper of one, with nothing between the two. */
function wrapsOneFunction(bytes: Uint8Array<ArrayBuffer>): boolean {
  const ending = bytes.length - ENDING.length;
  // The loader writes every size in two bytes.
  const [low = 0, high = 0] = bytes.subarray(BEGINNING.length);
  const typeEnds = BEGINNING.length + 2 + (low & 0x7f) + high * 128;
  return (
    bytes.length <= SMALL_MODULE &&
    typeEnds === ending &&
    isSame(bytes.subarray(0, BEGINNING.length), Uint8Array.from(BEGINNING)) &&
    isSame(bytes.subarray(ending), Uint8Array.from(ENDING))
  );
}

function isSame(one: Uint8Array, other: Uint8Array): boolean {
  return one.length === other.length && one.every((byte, i) => byte === other[i]);
}
