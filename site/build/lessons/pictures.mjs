/**
 * A lesson's pictures: SVG written by hand, or by a Python file with a function picture().
 *
 * @typedef {import("./folder.mjs").Lesson} Lesson
 * @typedef {import("./prose.mjs").Prose} Prose
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { listText, shownPath } from "./faults.mjs";

/**
 * The pictures that the prose shows, by name; faults go to the prose.
 * @param {Lesson} lesson
 * @param {Prose} prose
 * @param {import("./measure.mjs").Measurer} measurer
 * @returns {Promise<Map<string, string>>}
 */
export async function picturesOf(lesson, prose, measurer) {
  const folder = join(lesson.folder, "pictures");
  const files = existsSync(folder)
    ? readdirSync(folder).filter((file) => /\.(py|svg)$/.test(file))
    : [];
  /** @type {Map<string, string>} */
  const pictures = new Map();
  /** @type {{ name: string, file: string, source: string }[]} */
  const drawn = [];
  for (const directive of prose.directives.filter(({ name }) => name === "picture")) {
    const name = directive.argument;
    const file = files.find((each) => each === `${name}.py` || each === `${name}.svg`);
    if (!file) {
      const there = listText(files.map((each) => each.replace(/\.\w+$/, "")));
      prose.wrong(
        directive,
        `there is no picture "${name}"`,
        `write ${shownPath(folder)}/${name}.py or .svg; there is: ${there}.`,
      );
      continue;
    }
    const source = readFileSync(join(folder, file), "utf8");
    const path = shownPath(join(folder, file));
    if (file.endsWith(".svg")) keep(name, path, source, prose, pictures);
    else drawn.push({ name, file: path, source });
  }
  const jobs = drawn.map(({ file, source }) => ({
    kind: /** @type {const} */ ("picture"),
    file,
    source,
  }));
  const answers = await measurer.answers(jobs);
  drawn.forEach(({ name, file }, index) => {
    const answer = answers[index];
    if (answer && "svg" in answer) keep(name, file, answer.svg, prose, pictures);
    else if (answer && "message" in answer) {
      prose.faults.push({
        file,
        line: answer.line,
        fault: `the picture can't be drawn: ${answer.message}`,
        remedy: "mend the file: its function picture() gives the text of one <svg>.",
      });
    }
  });
  return pictures;
}

/**
 * @param {string} name
 * @param {string} file
 * @param {string} text
 * @param {Prose} prose
 * @param {Map<string, string>} pictures
 */
function keep(name, file, text, prose, pictures) {
  const svg = text.slice(Math.max(0, text.indexOf("<svg"))).trim();
  const wanted = [
    ["<svg", "one <svg>"],
    ["viewBox=", "a viewBox, so that it fits every screen"],
    ["<title", "a <title>: what it shows, for who can't see it"],
    ["<desc", "a <desc>: what one sees in it, for who can't"],
  ];
  for (const [sign = "", what = ""] of wanted) {
    if (svg.includes(sign)) continue;
    prose.faults.push({
      file,
      line: null,
      fault: `the picture has no ${sign}`,
      remedy: `give it ${what}.`,
    });
  }
  pictures.set(name, namedApart(svg, `picture-${name}`));
}

/**
 * Ids belong to the whole page: those of a picture get its name in front.
 * @param {string} svg
 * @param {string} prefix
 */
function namedApart(svg, prefix) {
  return svg
    .replace(/\bid="([^"]+)"/g, `id="${prefix}-$1"`)
    .replace(/url\(#([^)]+)\)/g, `url(#${prefix}-$1)`)
    .replace(/\bhref="#([^"]+)"/g, `href="#${prefix}-$1"`)
    .replace(/\baria-(labelledby|describedby)="([^"]+)"/g, (_whole, kind, ids) => {
      const renamed = String(ids)
        .split(/\s+/)
        .map((id) => `${prefix}-${id}`);
      return `aria-${kind}="${renamed.join(" ")}"`;
    });
}
