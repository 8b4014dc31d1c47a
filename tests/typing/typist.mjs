/**
 * Types a program as a person would: key by key, Enter at the end of a line, and then only as much of
 * Tab, Backspace and blanks as the indentation that the editor gave still needs.
 */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";

/**
 * @typedef {object} Piece what is typed, and the program round it
 * @property {string} name
 * @property {string} before
 * @property {string} typed
 * @property {string} after
 */

/** The learner's part of every solution, and the article's programs. @returns {Piece[]} */
export function pieces() {
  const lessons = join(ROOT, "lessons");
  const found = readdirSync(lessons, { recursive: true, encoding: "utf8" })
    .map((path) => path.replaceAll("\\", "/"))
    .sort();
  /** @param {string} path */
  const read = (path) => readFileSync(join(lessons, path), "utf8").trimEnd();
  const solutions = found
    .filter((path) => /^u[^/]+\/[^/]+\/solution\.py$/.test(path))
    .map((path) =>
      pieceOf(
        path.replace("/solution.py", ""),
        read(path.replace("solution", "starter")),
        read(path),
      ),
    );
  const programs = found
    .filter((path) => /^occupancy-grid-mapping\/programs\/.*\.py$/.test(path))
    .map((path) => ({ name: path, before: "", typed: read(path), after: "" }));
  return [...solutions, ...programs];
}

/**
 * What a solution has in place of its starter's lines.
 * @param {string} name
 * @param {string} starter
 * @param {string} solution
 * @returns {Piece}
 */
function pieceOf(name, starter, solution) {
  const [from, to] = [starter.split("\n"), solution.split("\n")];
  let start = 0;
  while (start < to.length && from[start] === to[start]) start++;
  let rest = 0;
  while (rest < Math.min(from.length, to.length) - start && from.at(-1 - rest) === to.at(-1 - rest))
    rest++;
  const end = to.length - rest;
  return {
    name,
    before: to
      .slice(0, start)
      .map((line) => `${line}\n`)
      .join(""),
    typed: to.slice(start, end).join("\n"),
    after: to
      .slice(end)
      .map((line) => `\n${line}`)
      .join(""),
  };
}

/**
 * Types a piece into the editor of a lab; gives the program that stands there then.
 * @param {import("@playwright/test").Page} page a page with one lab
 * @param {Piece} piece
 * @param {number} delay between two keys [ms]
 */
export async function typePiece(page, { before, typed, after }, delay) {
  const { keyboard } = page;
  const lab = page.locator("bugbot-lab");
  const program = () =>
    lab.evaluate((element) => /** @type {HTMLElement & { program: string }} */ (element).program);
  await page.getByRole("textbox", { name: "Program" }).focus();
  await keyboard.press("ControlOrMeta+a");
  await keyboard.insertText(`${before}${after}` || " ");
  await keyboard.press(before + after === "" ? "Backspace" : "ControlOrMeta+Home");
  for (let line = before.split("\n").length - 1; line > 0; line--)
    await keyboard.press("ArrowDown");
  let done = before;
  for (const [index, line] of typed.split("\n").entries()) {
    if (index > 0) {
      await keyboard.press("Enter", { delay });
      done += "\n";
    }
    const text = line.trimStart();
    // A blank line is left as it is: the editor takes its indentation away.
    if (text !== "") {
      const width = line.length - text.length;
      let there = indentation(await program(), done);
      while (there > width) {
        await keyboard.press("Backspace", { delay });
        const now = indentation(await program(), done);
        if (now >= there) break;
        there = now;
      }
      for (; there + 4 <= width; there += 4) await keyboard.press("Tab", { delay });
      await keyboard.type(" ".repeat(Math.max(0, width - there)) + text, { delay });
    }
    done += line;
  }
  return program();
}

/**
 * How many blanks stand after what has been typed so far.
 * @param {string} program
 * @param {string} done
 */
function indentation(program, done) {
  return /^ */.exec(program.slice(done.length))?.[0].length ?? 0;
}

/**
 * Where two texts part, in words; null if they are the same.
 * @param {string} wanted
 * @param {string} there
 */
export function parting(wanted, there) {
  if (wanted === there) return null;
  const [a, b] = [wanted.split("\n"), there.split("\n")];
  const line = a.findIndex((text, index) => text !== b[index]);
  const at = line < 0 ? a.length : line;
  return `line ${at + 1}: typed ${JSON.stringify(a[at] ?? "")}, there is ${JSON.stringify(b[at] ?? "")}`;
}
