/**
 * The numbers that a lesson's prose quotes, kept in the lesson's figures.json, so that a build in a fresh
 * copy of the project need not run every program. Each stands beside a hash of its runs, and the file
 * names what ran them (`figure-inputs.mjs`): a number of other runs, or by another simulator, is not used.
 */
import { existsSync, readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { write } from "../files.mjs";
import { listText, shownPath } from "./faults.mjs";

const ABOUT =
  "What the figures in lesson.md come to. Written by `npm run lesson:figures`, never by hand.";

/**
 * @typedef {{ runs: string, value: number }} Kept runs: the hash of the figure's runs
 * @typedef {{ figure: string, was: number | null, is: number }} Change was: null if none was kept
 */

export class KeptFigures {
  #path;
  #simulator;
  #text;
  /** What can be used of the file. @type {Record<string, Partial<Kept> | undefined>} */
  #fresh;
  /** What the file has, by this simulator or another. @type {Record<string, Partial<Kept> | undefined>} */
  #old;
  /** The lesson's figures as they are now. @type {Map<string, Kept>} */
  #now = new Map();

  /**
   * @param {string} folder of the lesson
   * @param {string} simulator its hash, and that of the interpreter
   */
  constructor(folder, simulator) {
    this.#path = join(folder, "figures.json");
    this.#simulator = simulator;
    this.#text = existsSync(this.#path) ? readFileSync(this.#path, "utf8") : "";
    const data = parsed(this.#text);
    this.#old = data.figures ?? {};
    this.#fresh = data.simulator === simulator ? this.#old : {};
  }

  /** The file, as messages name it. */
  get file() {
    return shownPath(this.#path);
  }

  /**
   * What a figure comes to, if that is known of just these runs.
   * @param {string} figure its text in the prose
   * @param {string} runs
   */
  valueOf(figure, runs) {
    const kept = this.#fresh[figure];
    return kept?.runs === runs && typeof kept.value === "number" ? kept.value : null;
  }

  /**
   * Take note of what a figure comes to now.
   * @param {string} figure
   * @param {string} runs
   * @param {number} value
   */
  add(figure, runs, value) {
    this.#now.set(figure, { runs, value });
  }

  /** Is the file just what it would be if it were written now? */
  get isCurrent() {
    return this.#text.replaceAll("\r\n", "\n") === this.#whole();
  }

  /** Figures with another value than the kept one, or with none. @returns {Change[]} */
  get changes() {
    return [...this.#now].flatMap(([figure, { value }]) => {
      const was = this.#old[figure]?.value ?? null;
      return was === value ? [] : [{ figure, was, is: value }];
    });
  }

  /** Has a figure come to another number than the one that is kept of the same runs? */
  get isContradicted() {
    return [...this.#now].some(([figure, { runs, value }]) => {
      const kept = this.valueOf(figure, runs);
      return kept !== null && kept !== value;
    });
  }

  /** Keep the lesson's figures, and no others. */
  write() {
    const text = this.#whole();
    if (text === "") rmSync(this.#path, { force: true });
    else write(this.#path, text);
  }

  /** One figure a line, in the order of their texts: that is easy to read in a diff, and to merge. */
  #whole() {
    if (this.#now.size === 0) return "";
    const lines = [...this.#now]
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([figure, { runs, value }]) => {
        return `    ${JSON.stringify(figure)}: { "value": ${JSON.stringify(value)}, "runs": "${runs}" }`;
      });
    return `{
  "about": ${JSON.stringify(ABOUT)},
  "simulator": "${this.#simulator}",
  "figures": {
${lines.join(",\n")}
  }
}
`;
  }
}

/**
 * What the file says; nothing if it is none of ours, after a merge with conflicts, say.
 * @param {string} text
 * @returns {{ simulator?: unknown, figures?: Record<string, Partial<Kept>> }}
 */
function parsed(text) {
  try {
    const data = JSON.parse(text);
    const { figures } = data;
    return typeof figures === "object" && figures !== null ? data : {};
  } catch {
    return {};
  }
}

/**
 * What to do about files that are not what they should be.
 * @param {readonly KeptFigures[]} stale
 */
export function staleText(stale) {
  const files = listText(stale.map(({ file }) => file));
  const is = stale.length === 1 ? "is" : "are";
  return `${files} ${is} missing or out of date.\nRemedy: \`npm run lesson:figures\` writes what the figures come to now.`;
}
