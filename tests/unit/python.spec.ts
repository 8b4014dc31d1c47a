/** The trace's second reader against its first: what Python writes is read here, and back. */
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { findPython } from "../../site/build/tools.mjs";
import { TraceError } from "../../site/src/trace/decode.ts";
import { FORMAT, KINDS, POINTS_PER_CM, VERSION } from "../../site/src/trace/events.ts";
import { readTraceFile, writeTraceFile } from "../../site/src/trace/file.ts";
import { MAT_CM, ROBOT_RADIUS_CM, turnBetween, wrapHeading } from "../../site/src/trace/frames.ts";
import { outcomeOf } from "../../site/src/trace/outcome.ts";
import { Trace } from "../../site/src/trace/trace.ts";
import { grow, header, TWO_SECONDS, traceOf, twoSeconds } from "./traces.ts";

/** What a piece of Python prints, with our packages to import from and `input` to read. */
function python(code: string, input = ""): string {
  return execFileSync(findPython(), ["-c", code], {
    env: { ...process.env, PYTHONPATH: join(ROOT, "py") },
    encoding: "utf8",
    input,
    maxBuffer: 1e8,
  });
}

test("events, format and mat are the same on both sides", () => {
  const theirs = JSON.parse(
    python(`
import json
from bugbot import frames, trace
print(json.dumps([trace.KINDS, trace.FORMAT, trace.VERSION, trace.POINTS_PER_CM,
  frames.MAT_CM, frames.ROBOT_RADIUS_CM,
  [frames.wrap_heading(h) for h in (-90, 0, 360, 725)],
  [frames.turn_between(a, b) for a, b in ((350, 10), (10, 350), (0, 180), (180, 0))]]))
`),
  );
  const headings = [-90, 0, 360, 725].map(wrapHeading);
  const turns = [
    turnBetween(350, 10),
    turnBetween(10, 350),
    turnBetween(0, 180),
    turnBetween(180, 0),
  ];
  expect(theirs).toEqual(
    JSON.parse(
      JSON.stringify([
        KINDS,
        FORMAT,
        VERSION,
        POINTS_PER_CM,
        MAT_CM,
        ROBOT_RADIUS_CM,
        headings,
        turns,
      ]),
    ),
  );
});

const PROGRAM = `
import sys
from bugbot import *
draw("free", [(102.5, 102.5), (-1, 500), (0.005, 7.125)], "#9ecae1", "squares", 5)
draw("names", [(10, 20, "é"), (30, 40)], "red", "text", 6)
draw("gone", [(1, 1)])
draw("gone", [])
plot("known %", 12.5)
forward(50)
for i in range(12):
    scan()
    wait(0.5)
    plot("known %", i)
led("orange")
beep(440)
print("done ✓", end="")
print("oh", file=sys.stderr)
1 / 0
`;

test("a run saved by Python is read here, with the same outcome", () => {
  const [file, outcome] = JSON.parse(
    python(
      `
import io, json, sys
from bugbot.run import run_program
from bugbot.run.outcome import outcome_of
from bugbot.trace import Trace
from bugbot.worlds import load
saved = io.StringIO()
trace = run_program(sys.stdin.read(), load("post-and-shelf"), 3)
trace.save(saved)
print(json.dumps([saved.getvalue(), outcome_of(trace)]))
`,
      PROGRAM,
    ),
  );
  const trace = readTraceFile(file);
  expect(outcomeOf(trace)).toEqual(outcome);
  expect(outcome.fault.type).toBe("ZeroDivisionError");
  expect(outcome.layers.free.points).toEqual([
    [102.5, 102.5],
    [-1, 327.67],
    [0, 7.12],
  ]);
});

test("a run written here is read by Python and comes back the same", () => {
  const trace = twoSeconds();
  const again = python(
    `
import sys
from bugbot.trace import Trace
Trace.load(sys.stdin).save(sys.stdout)
`,
    writeTraceFile(trace),
  );
  const back = readTraceFile(again);
  expect([...back.events()]).toEqual([...trace.events()]);
  expect(back.header).toEqual(JSON.parse(JSON.stringify(trace.header)));
  expect(outcomeOf(back)).toEqual(outcomeOf(trace));
});

test.describe("the outcome", () => {
  test("of a run solved by hand", () => {
    const outcome = outcomeOf(twoSeconds());
    expect(outcome).toEqual({
      status: "finished",
      message: "The program ended.",
      seconds: 2,
      console: "go\noh\ndone\n",
      notes: [],
      pose: { x: 110, y: 100, heading: 10 },
      series: {
        "known %": [
          [0.5, 10],
          [1, 30],
        ],
        walls: [[1, 1]],
      },
      layers: {
        free: {
          shape: "squares",
          size: 5,
          colour: "#9ecae1",
          points: [
            [102.5, 102.5],
            [107.5, 102.5],
            [112.5, 102.5],
          ],
        },
        walls: { shape: "squares", size: 5, colour: "black", points: [[127.5, 102.5]] },
        names: {
          shape: "text",
          size: 6,
          colour: "red",
          points: [
            [102.5, 102.5],
            [107.5, 102.5],
          ],
          texts: ["a", "b"],
        },
      },
      fault: null,
    });
  });

  test("needs a run that has ended", () => {
    expect(() => outcomeOf(traceOf([["line", 0, 1]]))).toThrow("a run that has ended");
  });
});

test.describe("a file that is no trace", () => {
  const whole = writeTraceFile(twoSeconds()).split("\n");
  const withLine = (number: number, line: string) =>
    whole.map((old, i) => (i === number - 1 ? line : old)).join("\n");
  const headerWith = (change: object) => withLine(1, JSON.stringify({ ...header(), ...change }));
  const points = whole.length - 1;

  const cases: [why: string, text: string, message: string | RegExp][] = [
    ["nothing", "", /^line 1: not JSON/],
    ["another file", "[1, 2]", 'line 1: not a trace: "format" should be "bugbot-trace"'],
    ["a later version", headerWith({ version: 2 }), "line 1: version 2; this reads version 1"],
    [
      "no program",
      headerWith({ program: 5 }),
      "line 1: program of the header should be text, not 5",
    ],
    [
      "no seed",
      headerWith({ seed: 1.5 }),
      "line 1: seed of the header should be a whole number, not 1.5",
    ],
    [
      "no world",
      headerWith({ world: null }),
      "line 1: world of the header should be a world, not null",
    ],
    [
      "no obstacles",
      headerWith({ world: { ...header().world, obstacles: {} } }),
      "line 1: obstacles of the world should be a list of rectangles",
    ],
    [
      "an obstacle without a width",
      headerWith({ world: { ...header().world, obstacles: [{ x: 1, y: 1, name: "a" }] } }),
      "line 1: width of an obstacle should be a number from 0, not nothing",
    ],
    [
      "no start",
      headerWith({ world: { ...header().world, start: undefined } }),
      "line 1: start of the world should be x, y and heading",
    ],
    ["a broken row", withLine(3, "[1,"), /^line 3: not JSON/],
    [
      "a wrong row",
      withLine(3, '["line",0,-2]'),
      "line 3: line of line should be a line number from 1, not -2",
    ],
    [
      "no points",
      whole.slice(0, -2).join("\n"),
      "the points, the last row, are missing: the file is cut short",
    ],
    [
      "points that are none",
      withLine(points, '["points","*"]'),
      `line ${points}: the points are not base64`,
    ],
    [
      "half a point",
      withLine(points, '["points","AAA="]'),
      `line ${points}: the points do not come in pairs`,
    ],
    [
      "points without text",
      withLine(points, '["points"]'),
      `line ${points}: points has 1 value (text), not 0`,
    ],
    [
      "rows after the points",
      `${whole.join("\n")}["line",9,1]`,
      `line ${points + 1}: there is more after the points, the last row`,
    ],
  ];
  for (const [why, text, message] of cases) {
    test(why, () => {
      expect(() => readTraceFile(text)).toThrow(TraceError);
      expect(() => readTraceFile(text)).toThrow(message);
    });
  }

  test("blank lines do no harm, and the line is still the right one", () => {
    const spaced = [whole[0], "", ...whole.slice(1)].join("\n");
    expect(readTraceFile(spaced).length).toBe(TWO_SECONDS.length);
    expect(() => readTraceFile(spaced.replace('["line",0,3]', '["line",0,0]'))).toThrow(/^line 4:/);
  });
});

test("points that came in many chunks are written as one store", () => {
  const trace = new Trace(header());
  for (let i = 0; i < 5; i++) {
    const points = Array.from({ length: 40_000 }, (_, k) => (k * 7 + i) % 200);
    grow(trace, [["layer", i, "a", "red", "dots", 2, i * 20_000, 20_000, null]], points);
  }
  const back = readTraceFile(writeTraceFile(trace));
  const pointsOf = (of: Trace) => of.layersAt(4).map((layer) => [...of.pointsOf(layer)]);
  expect(pointsOf(back)).toEqual(pointsOf(trace));
});
