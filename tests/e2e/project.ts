/**
 * A small project for stories: a program that maps from one spot, judged on two mats with two
 * seeds. It goes into the first task of the tiny lesson.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";

const DEMO = join(ROOT, "lessons/occupancy-grid-mapping/programs/demo-1-from-one-spot.py");

export const PROJECT = {
  check: `from grader import check, scoring

POINTS = scoring(
    "The per cent known, less 2 for each per cent of wrong walls; the mean of all runs.",
    lambda run, drawn: drawn.score.known_percent - 2 * drawn.score.wrong_walls_percent,
)


def judge(task, world, seeds):
    for trial in task.trials(world, seeds, seconds=20, scored=POINTS):
        trial.known(at_least=30).wrong_walls(at_most=20).took(at_most=11).bumps()
        trial.says_why(after="stops:")


@check("A wall across the mat", hint=0)
def wall(task):
    judge(task, "wall-ahead", [1])


@check("A pillar to look around")
def pillar(task):
    judge(task, "a-pillar", [1, 2])
`,
};

/** Demo 1, from where the robot stands in the project, turning for so many seconds. */
export function mapper(seconds: number): string {
  const program = readFileSync(DEMO, "utf8")
    .replace("START = (100, 100)", "START = (100, 40)")
    .replace(/^SECONDS = 13/m, `SECONDS = ${seconds}`);
  return `${program}print("stops: all round")\n`;
}
