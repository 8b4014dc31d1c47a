/**
 * Which bytes may become WebAssembly. A module is handed whatever functions of the interpreter it names,
 * so one of a program's own could call those that Python has no road to. Only two kinds pass: the loader's
 * own little modules, which wrap a single function, and the libraries of packages that the page
 * has sent. Imports nothing of ours.
 */

/** Modules of this size are the loader's own little ones [bytes]. */
const LITTLE_MODULE = 100;

export class WasmGate {
  #compiled = new Map<string, WebAssembly.Module>();
  #libraries: Uint8Array[] = [];
  #closed = false;

  /**
   * Stands in the place of `WebAssembly.Module` from now on. The loader makes 260 little modules, one for each
   * of its functions that Python may call, and a dozen of them differ: one that has been compiled is
   * given out again.
   */
  install(): void {
    const make = (Module: typeof WebAssembly.Module, bytes: unknown) => this.#make(Module, bytes);
    WebAssembly.Module = new Proxy(WebAssembly.Module, {
      construct: (Module, [bytes]: unknown[]) => make(Module, bytes),
    });
  }

  /** From now on only what has been `expect`ed is compiled, and little modules. */
  close(): void {
    this.#closed = true;
  }

  /** A library of a package that the page has sent may be compiled. */
  expect(library: Uint8Array): void {
    this.#libraries.push(library);
  }

  #make(Module: typeof WebAssembly.Module, given: unknown): WebAssembly.Module {
    // A copy: what has been looked at is what is compiled.
    const bytes = copyOf(given);
    if (bytes.length > LITTLE_MODULE) {
      if (this.#closed && !this.#libraries.some((library) => isSame(library, bytes))) {
        throw new WebAssembly.CompileError("This library is none of the site's");
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
