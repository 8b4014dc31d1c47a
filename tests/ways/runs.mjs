/** Tries ways out in as few runs as will do: a fresh interpreter takes longer than most of them. */

/** @typedef {import("./tools.mjs").Way} Way */

/** So many at most in a run that prints everything they say. */
const MOST = 12;

/** What the ways address, where nothing is meant to answer. */
const PORT = /\b4174\b/g;

/** An attempt that ends so was none: the test's own program is wrong, or lacks what it needs. */
const NO_ATTEMPT =
  /closed: (SyntaxError|IndentationError|NameError|NoRobotError|LookupError)|No module named 'numpy'|more than once per process/;

/**
 * Tries ways, and calls again for those that come after one which broke the interpreter. One that leaves
 * it spoiled is the last in its run.
 * @param {readonly Way[]} ways
 * @param {number} port where a program would reach somebody, were it let
 * @param {(program: string) => Promise<string>} run carries out a program; resolves to what it printed
 * @returns {Promise<Map<string, string>>} what each way said, by its name
 */
export async function tryWays(ways, port, run) {
  /** @type {Map<string, string>} */
  const said = new Map();
  // NumPy takes longer to load than most ways to try: those that need it come together.
  const sorted = ways.toSorted((one, other) => Number(needsNumpy(one)) - Number(needsNumpy(other)));
  const harmless = sorted.filter(({ spoils }) => !spoils);
  const spoiling = sorted.filter(({ spoils }) => spoils);
  while (harmless.length + spoiling.length > 0) {
    const tried = harmless.slice(0, MOST);
    const last = spoiling[0];
    if (last) tried.push(last);
    const printed = await run(severalOf(tried, port));
    const [before = "", ...told] = printed.split(/^TRYING/m);
    if (before.includes("OPEN")) throw new Error(`OPEN from somewhere else: ${before}`);
    if (told.length === 0) throw new Error(`no way was tried: ${printed.slice(0, 500)}`);
    for (const [index, text] of told.entries()) {
      const way = tried[index];
      if (!way) throw new Error(`a way said more than its own: ${text.slice(0, 500)}`);
      said.set(way.name, text);
      const list = way.spoils ? spoiling : harmless;
      list.splice(list.indexOf(way), 1);
    }
  }
  return said;
}

/**
 * What is wrong with what ways said, in words; empty if all are closed.
 * @param {ReadonlyMap<string, string>} said
 */
export function faultsOf(said) {
  return [...said].flatMap(([name, text]) => {
    if (text.includes("OPEN")) return [`${name} is open: ${text}`];
    return NO_ATTEMPT.test(text) ? [`${name} was not tried: ${text}`] : [];
  });
}

/**
 * A program that tries one way after the other, each with the modules as they were before.
 * @param {readonly Way[]} ways
 * @param {number} port
 */
function severalOf(ways, port) {
  const text = JSON.stringify(ways.map(({ program }) => program.replaceAll(PORT, String(port))));
  // The page looks into no text for what a program imports; and NumPy can't be loaded twice.
  const numpy = ways.some(needsNumpy) ? "import numpy" : "";
  return `import json, sys
from bugbot import wait
${numpy}
loaded = dict(sys.modules)
finders = list(sys.meta_path)
for source in json.loads(${JSON.stringify(text)}):
    print("\\nTRYING")
    try:
        exec(compile(source, "way out", "exec"), {"__name__": "__main__", "__builtins__": __builtins__})
    except BaseException as error:
        print("closed:", type(error).__name__, error)
    sys.modules.clear()
    sys.modules.update(loaded)
    sys.meta_path[:] = finders
    sys.setprofile(None)
    sys.settrace(None)
    wait(0.1)  # or the run ends for standing still
`;
}

/** @param {Way} way */
function needsNumpy({ program }) {
  return program.includes("import numpy");
}
