/**
 * A thread with the site's own Python, which runs the lessons' programs and draws their pictures.
 * Started and ended by `measure.mjs`; answers one job at a time.
 *
 * @typedef {{ kind: "run", program: string, world: string, seed: number }
 *   | { kind: "picture", file: string, source: string }} Job world: JSON
 * @typedef {{ outcome: string } | { svg: string } | { line: number | null, message: string }} Answer
 */
import { parentPort, workerData } from "node:worker_threads";
import { startFromSnapshot } from "../snapshot.mjs";

const RUN = `
def run(program, world, seed):
    import json
    from bugbot.run import outcome_of, run_program
    return json.dumps(outcome_of(run_program(program, json.loads(world), seed)))
run
`;

const NEEDS_NUMPY = `
def needs_numpy(program):
    from bridge.session import missing_modules
    return "numpy" in missing_modules(program)
needs_numpy
`;

const DRAW = `
def draw(file, source):
    import json, traceback
    module = {"__name__": "picture", "__file__": file}
    try:
        exec(compile(source, file, "exec"), module)
        if "picture" not in module:
            return json.dumps({"line": None, "message": "it defines no function picture()"})
        svg = module["picture"]()
    except BaseException as error:
        frames = traceback.extract_tb(error.__traceback__)
        lines = [frame.lineno for frame in frames if frame.filename == file]
        line = lines[-1] if lines else getattr(error, "lineno", None)
        return json.dumps({"line": line, "message": f"{type(error).__name__}: {error}"})
    if not isinstance(svg, str):
        return json.dumps({"line": None, "message": f"picture() gives {svg!r:.60}, not a text"})
    return json.dumps({"svg": svg})
draw
`;

const { snapshot, sources, numpy } = workerData;
const python = await startFromSnapshot(snapshot, sources);
const [run, needsNumpy, draw] = [RUN, NEEDS_NUMPY, DRAW].map((code) => python.runPython(code));
let hasNumpy = false;

parentPort?.on("message", (/** @type {Job} */ job) => parentPort?.postMessage(answer(job)));
parentPort?.postMessage("ready");

/**
 * @param {Job} job
 * @returns {Answer}
 */
function answer(job) {
  if (job.kind === "picture") return JSON.parse(draw(job.file, job.source));
  if (!hasNumpy && needsNumpy(job.program)) {
    python.unpackArchive(numpy, "wheel");
    python.runPython("import importlib; importlib.invalidate_caches(); del importlib");
    hasNumpy = true;
  }
  return { outcome: run(job.program, job.world, job.seed) };
}
