/**
 * Holds a lesson's references against its programs: which runs are needed, what they came to, and
 * whether what the checks say is so. Everything that is not becomes a fault with file and line.
 *
 * @typedef {import("./folder.mjs").Lesson} Lesson
 * @typedef {import("./folder.mjs").Program} Program
 * @typedef {import("./prose.mjs").Prose} Prose
 * @typedef {import("./prose.mjs").Place} Place
 * @typedef {import("./figure-grammar.mjs").Figure} Figure
 * @typedef {import("./figure-value.mjs").Outcome} Outcome
 * @typedef {import("../../src/trace/events.ts").World} World
 */
import { constantsOf, withConstants } from "./constants.mjs";
import { listText } from "./faults.mjs";
import { isTimed, runsHash } from "./figure-inputs.mjs";
import { figureValue, holds, NoSuchQuantity, numberText } from "./figure-value.mjs";

/**
 * Fills `prose.values` and adds to `prose.faults`. Only the figures that `kept` does not have are measured,
 * and those that are wanted `again`.
 * @param {Lesson} lesson
 * @param {Prose} prose
 * @param {readonly World[]} worlds that the lesson's programs may use
 * @param {{
 *   measurer: import("./measure.mjs").Measurer,
 *   kept: import("./kept-figures.mjs").KeptFigures,
 *   again?: ((figure: string) => boolean) | undefined,
 * }} from where the numbers come from
 */
export async function lookUp(lesson, prose, worlds, { measurer, kept, again }) {
  const wanted = prose.references.flatMap(({ reference, ...place }) => {
    if (reference.kind === "try") {
      const program = programOf(reference.program, lesson, prose, place);
      if (program) checkConstants(program, reference.constants, prose, place, true);
      return [];
    }
    const figures =
      reference.kind === "figure" ? [reference.figure] : [reference.left, reference.right];
    return figures
      .filter((figure) => typeof figure === "object")
      .map((figure) => ({ figure, place }));
  });
  const measured = wanted.flatMap(({ figure, place }) => {
    const program = programOf(figure.program, lesson, prose, place);
    const world = worlds.find(({ name }) => name === program?.world);
    if (!program || !world) return [];
    if (!checkConstants(program, figure.constants, prose, place, false)) return [];
    const source = withConstants(program.source, figure.constants);
    const jobs = (figure.seeds ?? [program.seed]).map((seed) => ({
      kind: /** @type {const} */ ("run"),
      program: source,
      world: JSON.stringify(world),
      seed,
    }));
    const runs = runsHash(jobs);
    const isKept = !isTimed(source);
    const value = isKept ? kept.valueOf(figure.text, runs) : null;
    const anew = isKept && (again?.(figure.text) ?? false);
    if (value === null || anew) return [{ figure, place, program, runs, jobs, isKept, anew }];
    prose.values.set(figure.text, value);
    kept.add(figure.text, runs, value);
    return [];
  });
  const answers = await Promise.all(
    measured.map(({ jobs, anew }) => measurer.answers(jobs, { anew })),
  );
  for (const [at, { figure, place, program, runs, jobs, isKept }] of measured.entries()) {
    /** @type {Outcome[]} */
    const outcomes = [];
    answers[at]?.forEach((answer, index) => {
      const outcome = "outcome" in answer ? JSON.parse(answer.outcome) : null;
      if (outcome?.status === "finished") {
        outcomes.push(outcome);
        return;
      }
      const ended = outcome?.message ?? ("message" in answer ? answer.message : "it gave nothing");
      const run = runText(figure, program, jobs[index]?.seed ?? null);
      const remedy =
        "mend the program, or take the reference out: a figure comes from a run that finishes.";
      prose.wrong(place, `the run of ${run} did not finish: ${ended}`, remedy);
    });
    if (outcomes.length < jobs.length) continue;
    try {
      const value = figureValue(figure, outcomes);
      prose.values.set(figure.text, value);
      if (isKept) kept.add(figure.text, runs, value);
    } catch (error) {
      if (!(error instanceof NoSuchQuantity)) throw error;
      const remedy = "mend the reference or the program.";
      prose.wrong(place, `{{ ${figure.text} }}: ${error.message}`, remedy);
    }
  }
  prose.runText = (figure) => runText(figure, lesson.programs.get(figure.program), null);
  checkChecks(prose);
}

/** @param {Prose} prose */
function checkChecks(prose) {
  for (const { reference, ...place } of prose.references) {
    if (reference.kind !== "check") continue;
    const left = prose.values.get(reference.left.text);
    const right =
      typeof reference.right === "number"
        ? reference.right
        : prose.values.get(reference.right.text);
    // One that could not be measured is a fault already.
    if (left === undefined || right === undefined || holds(reference, left, right)) continue;
    prose.wrong(
      place,
      `the check "${reference.text}" is not so: ${numberText(left, 4)} against ${numberText(right, 4)}`,
      "say in the prose what is measured, then mend the check; or mend the program.",
    );
  }
}

/**
 * @param {string} name
 * @param {Lesson} lesson
 * @param {Prose} prose
 * @param {Place} place
 */
function programOf(name, lesson, prose, place) {
  const program = lesson.programs.get(name);
  if (!program) {
    const there = listText([...lesson.programs.keys()]);
    prose.wrong(place, `there is no program "${name}"`, `name one of ${lesson.json}: ${there}.`);
  }
  return program;
}

/**
 * @param {Program} program
 * @param {Record<string, string>} values
 * @param {Prose} prose
 * @param {Place} place
 * @param {boolean} offered a reader is offered these values: they keep to the range in the comment
 */
function checkConstants(program, values, prose, place, offered) {
  const constants = constantsOf(program.source);
  let right = true;
  for (const [name, text] of Object.entries(values)) {
    const constant = constants.get(name);
    if (!constant) {
      const there = listText([...constants.keys()]);
      const fault = `${program.file} has no line ${name} = NUMBER`;
      prose.wrong(place, fault, `name one of its numbers: ${there}.`);
      right = false;
    } else if (offered && (Number(text) < constant.low || Number(text) > constant.high)) {
      const fault = `${name} = ${text} is outside ${constant.low} to ${constant.high}, the range in ${program.file}`;
      prose.wrong(place, fault, "mend the value, or the range in the program's comment.");
      right = false;
    }
  }
  return right;
}

/**
 * @param {Figure} figure
 * @param {Program | undefined} program
 * @param {number | null} one of its seeds
 */
function runText(figure, program, one) {
  const changed = Object.entries(figure.constants).map(([name, text]) => `${name} = ${text}`);
  const { seeds } = figure;
  const many = one === null && seeds && seeds.length > 1;
  const noise = many
    ? `seeds ${seeds[0]} to ${seeds.at(-1)}`
    : `seed ${one ?? seeds?.[0] ?? program?.seed ?? ""}`;
  const quantity = figure.text.slice(figure.text.indexOf(":") + 1).trim();
  const what = one === null ? `: ${quantity}` : "";
  const settings = changed.length > 0 ? ` with ${changed.join(", ")}` : "";
  return `${figure.program}${settings}, ${noise}${what}`;
}
