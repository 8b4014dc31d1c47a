/**
 * Removes modules from the interpreter's table of built-in modules, so that a program can't import or
 * recreate them: those that lead to JavaScript, that read and write any memory, and those for testing
 * Python itself. `bridge.seal` does the remainder. Imports nothing of ours.
 */
import type { PyodideAPI } from "pyodide";

/** The built-in modules that a program may import. All others are removed. */
const ALLOWED: ReadonlySet<string> = new Set(
  [
    "_abc _ast _asyncio _bisect _blake2 _bz2 _codecs _codecs_cn _codecs_hk _codecs_iso2022 _codecs_jp",
    "_codecs_kr _codecs_tw _collections _contextvars _csv _datetime _decimal _elementtree _functools",
    "_heapq _hmac _imp _io _json _locale _lsprof _lzma _md5 _multibytecodec _opcode _operator _pickle",
    "_posixsubprocess _queue _random _sha1 _sha2 _sha3 _signal _socket _sqlite3 _sre _stat _statistics",
    "_string _struct _suggestions _symtable _sysconfig _thread _tokenize _tracemalloc _types _typing",
    "_warnings _weakref _zoneinfo _zstd array atexit binascii builtins cmath errno faulthandler fcntl gc",
    "itertools marshal math mmap posix pyexpat select sys termios time unicodedata zlib",
  ]
    .join(" ")
    .split(" "),
);

/** The parts of Pyodide's module used here: memory, and the addresses of two of Python's variables. */
interface Memory {
  HEAPU8: Uint8Array;
  _PyImport_Inittab: number;
  __PyRuntime: number;
}

/** How far into Python's state to search for its pointer to the table [bytes]; it is at 1780. */
const SEARCHED = 16_384;

/**
 * The table is a list of pairs of addresses, of a name and of a function that makes the module, and ends
 * with two zeros. Python uses a copy that it made when it started. Throws if that can't be found.
 */
export function sealBuiltins(pyodide: PyodideAPI): void {
  const module = (pyodide as PyodideAPI & { _module: Memory })._module;
  const words = new Uint32Array(module.HEAPU8.buffer);
  const word = (address: number): number => words[address >> 2] ?? 0;
  const given = word(module._PyImport_Inittab);
  const tables = new Set([given]);
  for (let at = module.__PyRuntime; at < module.__PyRuntime + SEARCHED; at += 4) {
    const table = word(at);
    if (table !== 0 && word(table) === word(given) && word(table + 4) === word(given + 4)) {
      tables.add(table);
    }
  }
  if (given === 0 || tables.size !== 2) throw new Error("Python's table of modules was not found");
  for (const table of tables) {
    for (let entry = table; word(entry) !== 0; entry += 8) {
      const name = word(entry);
      const end = module.HEAPU8.indexOf(0, name);
      const text = new TextDecoder().decode(module.HEAPU8.slice(name, end));
      // Nothing can be imported by an empty name.
      if (text !== "" && !ALLOWED.has(text)) words[entry >> 2] = end;
    }
  }
}
