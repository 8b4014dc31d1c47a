/**
 * Gets PyYAML for the page, which reads the YAML file of a ROS map with it: the Python files of a
 * wheel on PyPI, checked against its hash. The parts in C are for another machine and stay out.
 */
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { CACHE, messageOf, sha256, write } from "./files.mjs";
import { findPython, runTool } from "./tools.mjs";

/** tests/requirements.txt and the extra `maps` of py/pyproject.toml name the same version. */
const VERSION = "6.0.3";
const SHA256 = "0f29edc409a6392443abf94b9cf89ce99889a1dd5376d94316ae5145dfedd5d6";
/** One wheel, whatever machine builds. */
const WHEEL = ["--platform", "manylinux2014_x86_64", "--python-version", "3.13"];
const KIND = ["--implementation", "cp", "--abi", "cp313", "--only-binary", ":all:"];

const KEEP_PYTHON = `
import sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as wheel, zipfile.ZipFile(sys.argv[2], "w") as kept:
    for entry in wheel.infolist():
        if entry.filename.startswith("yaml/") and entry.filename.endswith(".py") \\
                or entry.filename.endswith(("LICENSE", "METADATA")):
            kept.writestr(zipfile.ZipInfo(entry.filename), wheel.read(entry), zipfile.ZIP_DEFLATED, 9)
`;

/**
 * An archive of the package's Python files and its licence.
 * @param {(text: string) => void} log
 * @returns {Buffer}
 */
export function pyyamlArchive(log) {
  const cached = join(CACHE, "wheels", `pyyaml-${VERSION}.whl`);
  const isCached = existsSync(cached);
  const wheel = isCached ? readFileSync(cached) : download(cached);
  if (sha256(wheel) !== SHA256) {
    throw new Error(
      `PyYAML's wheel has the wrong hash.\n  wanted sha256 ${SHA256}\n  got    sha256 ${sha256(wheel)}\n` +
        `Remedy: if it is the cached file, delete ${cached}; otherwise do not trust that source.`,
    );
  }
  if (!isCached) {
    write(cached, wheel);
    log(`PyYAML ${VERSION} from PyPI, hash verified`);
  }
  return inFolder((folder) => {
    const kept = join(folder, "kept.zip");
    runTool(findPython(), ["-c", KEEP_PYTHON, cached, kept]);
    return readFileSync(kept);
  });
}

/**
 * @param {string} cached where it could be put by hand
 * @returns {Buffer}
 */
function download(cached) {
  return inFolder((folder) => {
    const pip = ["-m", "pip", "download", "--no-deps", "--quiet", "--disable-pip-version-check"];
    try {
      runTool(findPython(), [...pip, ...WHEEL, ...KIND, "--dest", folder, `PyYAML==${VERSION}`]);
    } catch (error) {
      throw new Error(
        `PyYAML could not be had from PyPI: ${messageOf(error)}\n` +
          `Remedy: put its wheel for CPython 3.13 on x86-64 Linux at ${cached} and start again.`,
      );
    }
    const [archive] = readdirSync(folder).filter((file) => file.endsWith(".whl"));
    if (!archive) throw new Error("pip downloaded no wheel of PyYAML");
    return readFileSync(join(folder, archive));
  });
}

/**
 * @template Made
 * @param {(folder: string) => Made} make
 * @returns {Made}
 */
function inFolder(make) {
  const folder = mkdtempSync(join(tmpdir(), "pyyaml-"));
  try {
    return make(folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
