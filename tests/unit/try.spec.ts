/** An experiment: what it runs, what it is compared with, and what undoing brings back. */
import { expect, test } from "@playwright/test";
import { Experiment } from "../../site/src/page/lab-try.ts";
import type { Note } from "../../site/src/page/status.ts";
import { triedFigures } from "../../site/src/page/try-figures.ts";
import type { RunRequest } from "../../site/src/runtime/messages.ts";
import { Trace } from "../../site/src/trace/trace.ts";
import { tryWords } from "../../site/src/ui/try-words.ts";
import { grow, header, traceOf, twoSeconds, WORLD } from "./traces.ts";

const PROGRAM = "CELL = 5  # cm (5 to 20)\nL_FREE = -0.4\nstop()\n";
const WITHOUT_FREE = PROGRAM.replace("-0.4", "0.0");
const LARGE_CELLS = PROGRAM.replace("5  #", "20  #");

function traceOfProgram({ program, seed }: Pick<RunRequest, "program" | "seed">): Trace {
  const trace = new Trace({ ...header(), program, seed });
  grow(trace, [["end", 1, "finished", ""]]);
  return trace;
}

/** A lab of which every run ends at once. */
function lab() {
  const log: string[] = [];
  const state = {
    program: PROGRAM,
    seed: 1,
    trace: null as Trace | null,
    earlier: null as Trace | null,
    note: null as Note | null,
  };
  const request = (): RunRequest => ({ program: state.program, world: WORLD, seed: state.seed });
  const run = (): Promise<Trace> => {
    state.earlier = state.trace;
    state.trace = traceOfProgram(request());
    return Promise.resolve(state.trace);
  };
  const experiment = new Experiment({
    request,
    replace: (program) => {
      state.program = program;
    },
    reset: () => log.push("reset"),
    run,
    runAside: (asked) => {
      log.push("run aside");
      const trace = traceOfProgram(asked);
      return { trace, done: Promise.resolve(trace), stop: () => {} };
    },
    // As in a lab, what is on show has these by its prototype.
    shown: () => Object.create(state),
    compareWith: (earlier) => {
      state.earlier = earlier;
    },
    restore: (trace, earlier) => Object.assign(state, { trace, earlier }),
    say: (note) => {
      state.note = note;
    },
    focusStatus: () => log.push("focus"),
  });
  const undo = (): void => {
    expect(state.note?.action?.label).toBe("Undo");
    state.note?.action?.act();
  };
  return { experiment, state, log, run, undo };
}

test("sets, runs, compares with the run before, and undoes all of it", async () => {
  const { experiment, state, log, run, undo } = lab();
  const first = await run();
  await experiment.begin({ L_FREE: 0 });
  expect(state.program).toBe(WITHOUT_FREE);
  expect(state.trace?.header.program).toBe(WITHOUT_FREE);
  expect(state.earlier).toBe(first);
  expect(state.note?.text).toBe("L_FREE = 0.0 in place of −0.4. Thin lines: the run without it.");
  undo();
  expect(state.program).toBe(PROGRAM);
  expect([state.trace, state.earlier]).toEqual([first, null]);
  expect(state.note?.text).toBe("L_FREE is −0.4 again.");
  expect(log).toEqual(["focus"]);
});

test("before the first run, the run to compare with is made after the experiment's own", async () => {
  const { experiment, state, log, undo } = lab();
  await experiment.begin({ L_FREE: 0 });
  expect(log).toEqual(["run aside"]);
  expect(state.trace?.header.program).toBe(WITHOUT_FREE);
  expect(state.earlier?.header.program).toBe(PROGRAM);
  undo();
  expect(state.trace?.header.program).toBe(PROGRAM);
});

test("the next experiment starts from the same program and is compared with the same run", async () => {
  const { experiment, state, run, undo } = lab();
  const first = await run();
  await experiment.begin({ L_FREE: 0 });
  await experiment.begin({ CELL: 20 });
  expect(state.program).toBe(LARGE_CELLS);
  expect(state.earlier).toBe(first);
  undo();
  expect(state.program).toBe(PROGRAM);
  expect(state.trace).toBe(first);
});

test("a program the reader has changed since is theirs: it is kept, and run to compare with", async () => {
  const { experiment, state, log, run, undo } = lab();
  await run();
  await experiment.begin({ L_FREE: 0 });
  state.program = `${state.program}wait(1)\n`;
  await experiment.begin({ CELL: 20 });
  expect(state.program).toBe(`${LARGE_CELLS.replace("-0.4", "0.0")}wait(1)\n`);
  expect(log).toEqual(["run aside"]);
  expect(state.earlier?.header.program).toBe(`${WITHOUT_FREE}wait(1)\n`);
  undo();
  expect(state.program).toBe(`${WITHOUT_FREE}wait(1)\n`);
});

test("other noise than in the run before: one with the same noise is made to compare with", async () => {
  const { experiment, state, log, run } = lab();
  await run();
  state.seed = 2;
  await experiment.begin({ L_FREE: 0 });
  expect(log).toEqual(["run aside"]);
  expect([state.trace?.header.seed, state.earlier?.header.seed]).toEqual([2, 2]);
});

test("several constants are one change; without one of them nothing is changed", async () => {
  const { experiment, state, log } = lab();
  await experiment.begin({ L_FREE: -0.85, CELL: 10 });
  expect(state.program).toBe("CELL = 10  # cm (5 to 20)\nL_FREE = -0.85\nstop()\n");
  state.program = state.program.replace("L_FREE = -0.85\n", "");
  const before = { ...state };
  expect(await experiment.begin({ L_FREE: 0, CELL: 20 })).toBeNull();
  expect(state).toEqual({ ...before, note: state.note });
  expect(state.note?.text).toBe(
    "This cannot be tried: the program has no line L_FREE = … with a number. Nothing has been changed.",
  );
  expect(state.note?.action?.label).toBe("Reset program");
  state.note?.action?.act();
  expect(log).toContain("reset");
});

test("a value that is there already is run, and there is nothing to undo", async () => {
  const { experiment, state } = lab();
  await experiment.begin({ CELL: 5 });
  expect(state.note).toEqual({ text: "CELL is 5 in this program already." });
  expect(state.trace?.header.program).toBe(PROGRAM);
});

test("what was changed is told, and taken back only as long as the program is as it was left", async () => {
  const { experiment, state } = lab();
  await experiment.begin({ L_FREE: 0 });
  expect(experiment.words).toBe("L_FREE = 0.0 in place of −0.4.");
  expect(experiment.inForce).toBe(true);
  state.program = `${state.program}wait(1)\n`;
  expect(experiment.undo()).toBeNull();
  state.program = WITHOUT_FREE;
  expect(experiment.undo()).toBe("L_FREE is −0.4 again.");
  expect(state.program).toBe(PROGRAM);
  expect(experiment.undo()).toBeNull();
});

test("its figures: the end of each line, the cells of each layer, the last line printed", () => {
  const before = twoSeconds();
  const now = traceOf(
    [
      ["layer", 0, "free", "#9ecae1", "squares", 5, 0, 1, null],
      ["layer", 0, "path", "red", "dots", 5, 0, 1, null],
      ["plot", 0.5, "known %", 12.345],
      ["plot", 0.5, "new", -1],
      ["print", 1, "stdout", "go\nfound 3\n"],
      ["end", 2, "finished", ""],
    ],
    [102.5, 102.5],
  );
  const figures = triedFigures(now, before);
  expect(figures).toEqual([
    { name: "known %", kind: "value", now: 12.345, before: 30 },
    { name: "new", kind: "value", now: -1, before: null },
    { name: "free", kind: "cells", now: 1, before: 3 },
    { name: "", kind: "printed", now: "found 3", before: "done" },
  ]);
  expect(figures.map(tryWords.figure)).toEqual([
    "known %: 12.3, before 30.",
    "new: −1.",
    "free: 1 cell, before 3.",
    "Printed: “found 3”, before “done”.",
  ]);
  expect(triedFigures(before, before).map(tryWords.figure)).toEqual([
    "known %: 30, as before.",
    "walls: 1, as before.",
    "free: 3 cells, as before.",
    "walls: 1 cell, as before.",
  ]);
});
