/**
 * Runs the lessons' programs and draws their pictures in the site's own Python, in threads, each
 * thing once: what came out is kept under .cache/lessons/ by the content of all that went in.
 */
import { existsSync, readFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";
import { Worker } from "node:worker_threads";
import { gunzipSync } from "node:zlib";
import { CACHE, filesBelow, ROOT, sha256, write } from "../files.mjs";

/**
 * @typedef {import("./python-worker.mjs").Job} Job
 * @typedef {import("./python-worker.mjs").Answer} Answer
 * @typedef {Awaited<ReturnType<typeof import("../python.mjs").preparePython>>} PreparedPython
 */

const FOLDER = join(CACHE, "lessons");
/** What a picture may import beside what is in the snapshot. */
const PY = join(ROOT, "py");

/** Longer than any run that does not compute for ever [ms]. */
const LONGEST_MS = 180_000;

/** So many jobs are worth another thread with its interpreter. */
const JOBS_A_THREAD = 4;

/**
 * @typedef {{
 *   file: string, job: Job,
 *   resolve: (answer: Answer) => void, reject: (error: unknown) => void,
 * }} Waiting
 */

export class Measurer {
  #python;
  #log;
  #sources;
  #base;
  /** What no thread has begun yet. @type {Waiting[]} */
  #waiting = [];
  /** The answers on their way, by file: what is asked for twice is measured once. @type {Map<string, Promise<Answer>>} */
  #asked = new Map();
  #working = false;

  /**
   * @param {PreparedPython} python
   * @param {(text: string) => void} log
   */
  constructor(python, log = () => {}) {
    this.#python = python;
    this.#log = log;
    const { folder, manifest } = python;
    const packed = readFileSync(join(folder, manifest.files.sources?.path ?? ""));
    /** @type {Record<string, string>} */
    const sources = JSON.parse(gunzipSync(packed).toString("utf8"));
    for (const name of ["mapping", "sketch"]) {
      for (const path of filesBelow(join(PY, name), (file) => file.endsWith(".py"))) {
        sources[`${name}/${path}`] = readFileSync(join(PY, name, path), "utf8");
      }
    }
    this.#sources = sources;
    this.#base = {
      run: hashOf(sources, manifest.pyodide, /^bugbot\//),
      picture: hashOf(
        sources,
        manifest.pyodide,
        /^(bugbot\/frames|bugbot\/errors|mapping\/|sketch\/)/,
      ),
    };
  }

  /**
   * The answer to every job, in order. Whoever asks meanwhile shares the threads.
   * @param {readonly Job[]} jobs
   * @param {{ anew?: boolean }} [options] anew: even where the answer is known from before
   * @returns {Promise<Answer[]>}
   */
  answers(jobs, { anew = false } = {}) {
    return Promise.all(jobs.map((job) => this.#answer(job, anew)));
  }

  /**
   * @param {Job} job
   * @param {boolean} anew
   * @returns {Promise<Answer>}
   */
  #answer(job, anew) {
    const file = this.#fileOf(job);
    const asked = this.#asked.get(file);
    if (asked) return asked;
    if (!anew && existsSync(file)) {
      return Promise.resolve(JSON.parse(readFileSync(file, "utf8")));
    }
    /** @type {Promise<Answer>} */
    const answer = new Promise((resolve, reject) => {
      this.#waiting.push({ file, job, resolve, reject });
    });
    this.#asked.set(file, answer);
    if (!this.#working) {
      this.#working = true;
      // First all who ask now have asked: their number says how many threads are worth starting.
      setImmediate(() => this.#work());
    }
    return answer;
  }

  /** @param {Job} job */
  #fileOf(job) {
    const input = JSON.stringify([this.#base[job.kind], job]);
    return join(FOLDER, `${job.kind}-${sha256(input).slice(0, 24)}.json`);
  }

  async #work() {
    const threads = Math.min(
      availableParallelism(),
      Math.ceil(this.#waiting.length / JOBS_A_THREAD),
    );
    const start = Date.now();
    this.#log(`measuring: ${this.#waiting.length} runs and pictures that are new or have changed`);
    let done = 0;
    const one = async () => {
      let thread = await this.#thread();
      for (let next = this.#waiting.shift(); next; next = this.#waiting.shift()) {
        const { file, job, resolve, reject } = next;
        const answer = await ask(thread, job).catch((error) => {
          reject(error);
          throw error;
        });
        // A failure is not kept: it may lie in something that is no part of the key.
        if (answer && !("message" in answer)) write(file, JSON.stringify(answer));
        resolve(answer ?? { line: null, message: `it did not end within ${LONGEST_MS / 1000} s` });
        this.#asked.delete(file);
        if (answer === null) {
          // It computes for ever: only ending the thread ends it.
          await thread.terminate();
          thread = await this.#thread();
        }
        done += 1;
        if (done % 20 === 0) this.#log(`measuring: ${done} done, ${this.#waiting.length} to go`);
        // Who waited for this answer may have the next jobs for the thread.
        await new Promise(setImmediate);
      }
      await thread.terminate();
    };
    try {
      await Promise.all(Array.from({ length: threads }, one));
      this.#log(`measured in ${((Date.now() - start) / 1000).toFixed(1)} s`);
    } catch (error) {
      for (const { reject } of this.#waiting.splice(0)) reject(error);
      this.#asked.clear();
    }
    // Somebody may have asked while the threads were ending.
    this.#working = this.#waiting.length > 0;
    if (this.#working) setImmediate(() => this.#work());
  }

  /** @returns {Promise<Worker>} */
  #thread() {
    const { folder, manifest } = this.#python;
    /** @param {string} name */
    const bytes = (name) => readFileSync(join(folder, manifest.files[name]?.path ?? ""));
    const thread = new Worker(new URL("python-worker.mjs", import.meta.url), {
      workerData: {
        snapshot: new Uint8Array(gunzipSync(bytes("snapshot"))),
        sources: this.#sources,
        numpy: new Uint8Array(bytes("numpy")).buffer,
      },
    });
    return new Promise((resolve, reject) => {
      thread.once("message", () => resolve(thread));
      thread.once("error", reject);
    });
  }
}

/**
 * The thread's answer, or null if it gives none in time.
 * @param {Worker} thread
 * @param {Job} job
 * @returns {Promise<Answer | null>}
 */
function ask(thread, job) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => {
      done();
      resolve(null);
    }, LONGEST_MS);
    const done = () => {
      clearTimeout(timer);
      thread.off("message", onAnswer);
      thread.off("error", onError);
    };
    /** @param {Answer} answer */
    const onAnswer = (answer) => {
      done();
      resolve(answer);
    };
    /** @param {Error} error */
    const onError = (error) => {
      done();
      reject(error);
    };
    thread.on("message", onAnswer);
    thread.on("error", onError);
    thread.postMessage(job);
  });
}

/**
 * @param {Record<string, string>} sources
 * @param {string} pyodide
 * @param {RegExp} which
 */
function hashOf(sources, pyodide, which) {
  const parts = Object.keys(sources).filter((path) => which.test(path));
  return sha256(JSON.stringify([pyodide, parts.sort().map((path) => [path, sources[path]])]));
}
