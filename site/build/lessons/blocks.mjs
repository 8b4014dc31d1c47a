/**
 * The HTML of the directives: a lab with its program, a task, a picture, a live figure. All of it
 * is complete without scripts; the elements take these nodes over.
 *
 * @typedef {import("./folder.mjs").Lesson} Lesson
 * @typedef {import("./folder.mjs").Task} Task
 * @typedef {import("./prose.mjs").Prose} Prose
 * @typedef {import("./prose.mjs").PlacedDirective} PlacedDirective
 * @typedef {import("markdown-it").Token} Token
 * @typedef {{ title: Token[], statement: Token[], hints: Token[][] }} TaskWords
 * @typedef {{
 *   lesson: Lesson,
 *   prose: Prose,
 *   taskWords: ReadonlyMap<string, TaskWords>,
 *   pictures: ReadonlyMap<string, string>,
 *   live: Readonly<Record<string, string>>,
 * }} Parts
 */
import { listText } from "./faults.mjs";
import { programHtml } from "./highlight.mjs";
import { escapeHtml } from "./html.mjs";

const DIRECTIVES = ["program", "task", "picture", "live"];

/**
 * Notes what is wrong with the directives of a page: unknown ones, names that there are not, and
 * programs and tasks that are shown twice or never.
 * @param {Parts} parts
 */
export function checkDirectives({ lesson, prose, live }) {
  const known = new Map([
    ["program", [...lesson.programs.keys()]],
    ["task", [...lesson.tasks.keys()]],
    ["live", Object.keys(live)],
  ]);
  /** @type {Set<string>} */
  const seen = new Set();
  for (const directive of prose.directives) {
    const { name, argument } = directive;
    const key = `${name} ${argument}`;
    const there = known.get(name);
    if (!DIRECTIVES.includes(name)) {
      const signs = listText(DIRECTIVES.map((each) => `::${each} NAME`));
      prose.wrong(directive, `there is no directive ::${name}`, `write one of ${signs}.`);
    } else if (there && !there.includes(argument)) {
      prose.wrong(
        directive,
        `there is no ${name} "${argument}"`,
        `name one of: ${listText(there)}.`,
      );
    } else if (seen.has(key)) {
      prose.wrong(directive, `::${key} stands here for the second time`, "leave one of them out.");
    }
    seen.add(key);
  }
  const referred = prose.references.flatMap(({ reference }) => {
    if (reference.kind === "try") return [];
    const figures =
      reference.kind === "figure" ? [reference.figure] : [reference.left, reference.right];
    return figures.map((figure) => (typeof figure === "object" ? figure.program : ""));
  });
  for (const name of lesson.programs.keys()) {
    if (seen.has(`program ${name}`) || referred.includes(name)) continue;
    const place = { file: lesson.json, line: lesson.lineOf(["programs", name]) };
    prose.wrong(
      place,
      `the program "${name}" is shown nowhere`,
      `write ::program ${name}, or take it out.`,
    );
  }
  [...lesson.tasks.keys()].forEach((name, index) => {
    if (seen.has(`task ${name}`)) return;
    const place = { file: lesson.json, line: lesson.lineOf(["tasks", index, "name"]) };
    prose.wrong(
      place,
      `the task "${name}" is shown nowhere`,
      `write ::task ${name}, or take it out.`,
    );
  });
  for (const { reference, ...place } of prose.references) {
    if (reference.kind !== "try" || !lesson.programs.has(reference.program)) continue;
    if (seen.has(`program ${reference.program}`)) continue;
    const remedy = `write ::program ${reference.program} where its lab belongs.`;
    prose.wrong(place, `the program "${reference.program}" has no lab on this page`, remedy);
  }
}

/**
 * @param {Parts} parts
 * @returns {(directive: PlacedDirective) => string}
 */
export function blockWriter({ lesson, prose, taskWords, pictures, live }) {
  let pictureNumber = 0;
  return (directive) => {
    const { argument, caption } = directive;
    switch (directive.name) {
      case "program":
        return labHtml(lesson, argument);
      case "task": {
        const task = lesson.tasks.get(argument);
        const words = taskWords.get(argument);
        return task && words ? taskHtml(task, words, prose) : "";
      }
      case "picture": {
        pictureNumber += 1;
        const words = `<b>Figure ${pictureNumber}.</b> ${prose.render(caption)}`;
        const svg = pictures.get(argument) ?? "";
        return `<figure class="picture" id="picture-${escapeHtml(argument)}">${svg}<figcaption>${words}</figcaption></figure>\n`;
      }
      case "live": {
        const figure = live[argument] ?? "";
        if (caption.length === 0) return `<div class="live">${figure}</div>\n`;
        return `<figure class="live">${figure}<figcaption>${prose.render(caption)}</figcaption></figure>\n`;
      }
      default:
        return "";
    }
  };
}

/**
 * @param {Lesson} lesson
 * @param {string} name
 */
function labHtml(lesson, name) {
  const program = lesson.programs.get(name);
  if (!program) return "";
  const title = escapeHtml(program.title);
  const world = escapeHtml(program.world);
  return `<bugbot-lab id="lab-${name}" program-of="${name}" label="${title}" world="${world}" seed="${program.seed}">
<div class="plain-lab">
<p class="plain-title">${title}</p>
${programHtml(program.source, `Program: ${program.title}`)}
</div>
</bugbot-lab>
`;
}

/**
 * @param {Task} task
 * @param {TaskWords} words
 * @param {Prose} prose
 */
function taskHtml(task, words, prose) {
  const title = prose.render(words.title);
  const stretch = task.stretch
    ? `<p>This task goes a step further than the lesson needs.</p>\n`
    : "";
  const hints = words.hints.map(
    (hint, index) =>
      `<details class="task-hint"><summary>Hint ${index + 1}</summary>${prose.render(hint)}</details>`,
  );
  return `<bugbot-task id="task-${task.name}" name="${task.name}">
<h3>${title}</h3>
<div class="task-statement">${prose.render(words.statement)}</div>
<div class="task-plain">
${stretch}<p>Start from this program:</p>
${programHtml(task.starter, `Program to start from: ${task.title}`)}
</div>
${hints.join("\n")}
</bugbot-task>
`;
}

/**
 * What the scripts of a page need to know: site/src/page/lesson-data.ts has the same in its types.
 * @param {Lesson} lesson
 */
export function lessonData(lesson) {
  const programs = [...lesson.programs.values()].map(({ name, source, world, seed, title }) => [
    name,
    { source, world, seed, title },
  ]);
  const tasks = [...lesson.tasks.values()].map(
    ({ name, title, starter, solution, check, world, seed, practice, stretch }) => [
      name,
      { title, starter, solution, check, world, seed, practice, stretch },
    ],
  );
  return {
    format: 1,
    lesson: lesson.slug,
    code: lesson.about.code ?? "",
    title: lesson.about.title,
    worlds: lesson.worlds,
    programs: Object.fromEntries(programs),
    tasks: Object.fromEntries(tasks),
  };
}
