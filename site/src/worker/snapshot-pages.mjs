/**
 * A snapshot of Python's memory as a file: of its pages only those that a fresh interpreter's memory
 * does not have (12 of 33 MB), and of those that a fresh one has otherwise, the difference. Whoever
 * starts from it has a fresh memory too. Written by the build, read by the worker. Imports nothing.
 *
 * The file, in words of 32 bits: MAGIC, bytes of Pyodide's notes, bytes of the memory, number of
 * differences, number of pages; the index of each page, differences first; the notes; the pages.
 */

const MAGIC = 0x70616765;
const HEADER_WORDS = 5;
const PAGE_BYTES = 4096;
const PAGE_WORDS = PAGE_BYTES / 4;

/** WebAssembly's memory grows by so much. */
const GROWTH_BYTES = 65_536;

/**
 * @param {Uint8Array} snapshot as Pyodide makes it
 * @param {Uint8Array} fresh the memory of an interpreter that has not started
 * @param {Uint8Array} starting the memory of one just before a snapshot is put in its place: what
 *   has been written by then has to be overwritten, even if the snapshot has it as in a fresh one
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function packSnapshot(snapshot, fresh, starting) {
  const start = startOf(snapshot);
  const notes = padded(snapshot.subarray(0, start));
  const memory = padded(snapshot.subarray(start), PAGE_BYTES);
  /** @type {number[]} */
  const differences = [];
  /** @type {number[]} */
  const whole = [];
  for (let page = 0; page * PAGE_BYTES < memory.length; page += 1) {
    const inFresh = pageOf(fresh, page);
    const asFresh = (/** @type {Uint8Array} */ other) =>
      pageOf(other, page).every((byte, i) => byte === inFresh[i]);
    if (asFresh(memory) && asFresh(starting)) continue;
    const empty = inFresh.every((byte) => byte === 0);
    (empty ? whole : differences).push(page);
  }
  const pages = differences.concat(whole);
  const header = [MAGIC, notes.length, memory.length, differences.length, pages.length, ...pages];
  const file = new Uint8Array(header.length * 4 + notes.length + pages.length * PAGE_BYTES);
  file.set(new Uint8Array(Uint32Array.from(header).buffer));
  file.set(notes, header.length * 4);
  let at = header.length * 4 + notes.length;
  for (const [i, page] of pages.entries()) {
    const inFresh = pageOf(fresh, page);
    const isDifference = i < differences.length;
    file.set(
      pageOf(memory, page).map((byte, k) => (isDifference ? byte ^ (inFresh[k] ?? 0) : byte)),
      at,
    );
    at += PAGE_BYTES;
  }
  return file;
}

/**
 * Where the memory begins in a snapshot as Pyodide makes it: its second word, behind its notes.
 * @param {Uint8Array} snapshot
 */
export function startOf(snapshot) {
  return new Uint32Array(snapshot.buffer, snapshot.byteOffset, 2)[1] ?? 0;
}

/**
 * @param {WebAssembly.Memory} memory has at least so many bytes afterwards
 * @param {number} bytes
 */
export function growTo(memory, bytes) {
  const more = bytes - memory.buffer.byteLength;
  if (more > 0) memory.grow(Math.ceil(more / GROWTH_BYTES));
}

/** A snapshot from its file, to start one interpreter from. */
export class Snapshot {
  #pages;
  #differences;
  #notes;
  #data;
  #memoryBytes;
  /** @type {WebAssembly.Instance | null} */
  #instance = null;

  /** @param {ArrayBuffer} file is changed: it serves one start */
  constructor(file) {
    const [magic, notesBytes = 0, memoryBytes = 0, differences = 0, pages = 0] = new Uint32Array(
      file,
      0,
      HEADER_WORDS,
    );
    if (magic !== MAGIC) throw new Error("the snapshot is no snapshot");
    this.#memoryBytes = memoryBytes;
    this.#differences = differences;
    this.#pages = new Uint32Array(file, HEADER_WORDS * 4, pages);
    const notesAt = (HEADER_WORDS + pages) * 4;
    this.#notes = new Uint8Array(file, notesAt, notesBytes);
    this.#data = new Uint8Array(file, notesAt + notesBytes, pages * PAGE_BYTES);
  }

  /**
   * To be called with an instance of the interpreter that has not started.
   * @param {WebAssembly.Instance} instance
   */
  begin(instance) {
    this.#instance = instance;
    const memory = memoryOf(instance);
    growTo(memory, this.#memoryBytes);
    const fresh = new Uint32Array(memory.buffer);
    const { buffer, byteOffset } = this.#data;
    const data = new Uint32Array(buffer, byteOffset, this.#differences * PAGE_WORDS);
    let from = 0;
    for (let i = 0; i < data.length; i += 1) {
      if (i % PAGE_WORDS === 0) from = (this.#pages[i / PAGE_WORDS] ?? 0) * PAGE_WORDS - i;
      data[i] = (data[i] ?? 0) ^ (fresh[from + i] ?? 0);
    }
  }

  /**
   * What Pyodide's loader is to be given. It reads the notes, then takes what lies behind them as
   * the memory: in that moment the pages are put into place, and nothing is left for it to copy.
   * @returns {Uint8Array}
   */
  forLoader() {
    return new Notes(this.#notes, () => this.#restore());
  }

  #restore() {
    const instance = this.#instance;
    if (!instance) throw new Error("a snapshot needs the instance before the interpreter starts");
    const { buffer } = memoryOf(instance);
    const heap = new Uint8Array(buffer);
    const words = new Uint32Array(buffer);
    const trampoline = trampolineAt(instance, words) / 4;
    const own = words[trampoline] ?? 0;
    const pages = this.#pages;
    // Neighbours in one go.
    for (let i = 0; i < pages.length; ) {
      let end = i + 1;
      while (end < pages.length && pages[end] === (pages[end - 1] ?? 0) + 1) end += 1;
      const run = this.#data.subarray(i * PAGE_BYTES, end * PAGE_BYTES);
      heap.set(run, (pages[i] ?? 0) * PAGE_BYTES);
      i = end;
    }
    words[trampoline] = own;
  }
}

/**
 * The memory of an instance of the interpreter.
 * @param {WebAssembly.Instance} instance
 */
export function memoryOf({ exports: { memory } }) {
  if (!(memory instanceof WebAssembly.Memory)) throw new Error("Python has no memory");
  return memory;
}

/**
 * Where Python keeps the function by which it calls others with another number of arguments. Each
 * engine has its own, and some none: then each such call goes through JavaScript, which makes
 * programs a fifth slower. So a snapshot's must not take its place.
 * @param {WebAssembly.Instance} instance
 * @param {Uint32Array} words its memory
 */
function trampolineAt({ exports }, words) {
  const [runtime, offset] = ["_PyRuntime", "_PyEM_EMSCRIPTEN_TRAMPOLINE_OFFSET"].map((name) => {
    const value = exports[name];
    if (!(value instanceof WebAssembly.Global)) throw new Error(`Python has no ${name}`);
    return Number(value.value);
  });
  return (runtime ?? 0) + (words[(offset ?? 0) / 4] ?? 0);
}

/** Notes that tell when what lies behind them is asked for. */
class Notes extends Uint8Array {
  #onEnd;

  static get [Symbol.species]() {
    return Uint8Array;
  }

  /**
   * @param {Uint8Array} notes
   * @param {() => void} onEnd
   */
  constructor(notes, onEnd) {
    super(notes);
    this.#onEnd = onEnd;
  }

  /**
   * @param {number} [begin]
   * @param {number} [end]
   * @override
   */
  subarray(begin, end) {
    if (end === undefined) this.#onEnd();
    return super.subarray(begin, end);
  }
}

/**
 * @param {Uint8Array} memory
 * @param {number} page
 */
function pageOf(memory, page) {
  const bytes = memory.subarray(page * PAGE_BYTES, (page + 1) * PAGE_BYTES);
  return padded(bytes, PAGE_BYTES);
}

/**
 * With zeros up to a whole number of units, one at least.
 * @param {Uint8Array} bytes
 */
function padded(bytes, unit = 4) {
  const length = Math.max(1, Math.ceil(bytes.length / unit)) * unit;
  if (length === bytes.length) return bytes;
  const whole = new Uint8Array(length);
  whole.set(bytes);
  return whole;
}
