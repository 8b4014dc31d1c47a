import { expect, test } from "@playwright/test";
import { TraceError } from "../../site/src/trace/decode.ts";
import { KINDS } from "../../site/src/trace/events.ts";
import { readTraceFile, writeTraceFile } from "../../site/src/trace/file.ts";
import { Trace } from "../../site/src/trace/trace.ts";
import { grow, header, TWO_SECONDS, traceOf, twoSeconds, WORLD } from "./traces.ts";

const names = (layers: { name: string }[]) => layers.map((layer) => layer.name);

test.describe("look-ups by time", () => {
  test("the pose lies on the line between two poses, and the turn is the shorter one", () => {
    const trace = twoSeconds();
    expect(trace.poseAt(0.25)).toEqual({ t: 0.25, x: 102.5, y: 100, heading: 355 });
    expect(trace.poseAt(0.75)).toEqual({ t: 0.75, x: 107.5, y: 100, heading: 5 });
    expect(trace.poseAt(0.5)).toEqual({ t: 0.5, x: 105, y: 100, heading: 0 });
  });

  test("before the first pose the robot stands at the start, after the last it stays", () => {
    expect(new Trace(header()).poseAt(3)).toEqual({ t: 3, ...WORLD.start });
    expect(twoSeconds().poseAt(1.5)).toEqual({ t: 1.5, x: 110, y: 100, heading: 10 });
  });

  test("half a turn goes clockwise", () => {
    const trace = traceOf([
      ["pose", 0, 0, 0, 270],
      ["pose", 1, 0, 0, 90],
    ]);
    expect(trace.poseAt(0.5).heading).toBe(0);
  });

  test("the trail begins and ends between poses", () => {
    expect([...twoSeconds().trail(0.25, 0.75)]).toEqual([102.5, 100, 105, 100, 107.5, 100]);
    expect([...twoSeconds().trail(0.6, 0.7)]).toEqual([106, 100, 107, 100]);
  });

  test("the scan is the last one at or before", () => {
    const trace = twoSeconds();
    expect(trace.scanAt(0.49)?.beams).toEqual([-5, 50, 5, 200]);
    expect(trace.scanAt(0.5)).toEqual({ t: 0.5, x: 105, y: 100, heading: 0, beams: [0, 80] });
    expect(traceOf([["scan", 1, 0, 0, 0, []]]).scanAt(0.9)).toBeNull();
  });

  test("layers come in order of first drawing, each as it was last drawn", () => {
    const trace = twoSeconds();
    expect(names(trace.layersAt(0))).toEqual(["free"]);
    expect(names(trace.layersAt(1))).toEqual(["free", "walls", "names"]);
    expect(trace.layersAt(0.9)[0]?.count).toBe(2);
    expect(trace.layersAt(1)[0]?.count).toBe(3);
  });

  test("points are views in hundredths of a cm, also across the pieces they came in", () => {
    const trace = new Trace(header());
    grow(trace, [["layer", 0, "a", "black", "dots", 2, 0, 1, null]], [1, 2]);
    grow(trace, [["layer", 0, "b", "black", "dots", 2, 0, 3, null]], [3, 4, -5, 6.25]);
    const [a, b] = trace.layersAt(0);
    if (!a || !b) throw new Error("two layers");
    expect([...trace.pointsOf(a)]).toEqual([100, 200]);
    expect([...trace.pointsOf(b)]).toEqual([100, 200, 300, 400, -500, 625]);
    expect(trace.pointsOf(a).buffer).toBe(trace.pointsOf(a).buffer);
  });

  test("a layer has its own points, from the middle of the store too", () => {
    const trace = twoSeconds();
    const pointsAt = (t: number) => trace.layersAt(t).map((layer) => [...trace.pointsOf(layer)]);
    expect(pointsAt(0.5)).toEqual([
      [10250, 10250, 10750, 10250],
      [12750, 10250],
    ]);
  });

  test("printed text grows with time", () => {
    const trace = twoSeconds();
    expect(trace.consoleText(0.9)).toBe("go\n");
    expect(trace.consoleText(1)).toBe("go\noh\n");
    expect(trace.consoleUpTo(2)).toBe(3);
  });

  test("line, light, tone and touches", () => {
    const trace = twoSeconds();
    expect([trace.lineAt(0.99), trace.lineAt(1)]).toEqual([3, 4]);
    expect([trace.ledAt(0.9), trace.ledAt(2)]).toEqual([
      null,
      { t: 1, red: 255, green: 0, blue: 0 },
    ]);
    expect(trace.beepAt(1.2)?.freq).toBe(440);
    expect(trace.beepAt(1.25)).toBeNull();
    expect(trace.bumpsUpTo(1.1)).toEqual([]);
    expect(trace.bumpsUpTo(2)).toEqual([{ t: 1.2, x: 115, y: 100 }]);
  });

  test("plotted lines are columns under their names", () => {
    const { series } = twoSeconds();
    expect([...series.keys()]).toEqual(["known %", "walls"]);
    expect([...(series.get("known %")?.t.view() ?? [])]).toEqual([0.5, 1]);
    expect([...(series.get("known %")?.value.view() ?? [])]).toEqual([10, 30]);
  });

  test("ticks are the times at which the program did something", () => {
    expect([...twoSeconds().ticks.view()]).toEqual([0, 0.5, 1, 2]);
  });

  test("the end closes the run", () => {
    const trace = twoSeconds();
    expect([trace.duration, trace.complete, trace.end?.status]).toEqual([2, true, "finished"]);
    expect(new Trace(header()).complete).toBe(false);
  });

  test("every event comes out again as it went in", () => {
    const rows = Array.from(twoSeconds().events(), (event) => {
      const values: Record<string, unknown> = { ...event };
      return [event.kind, ...KINDS[event.kind].map((field) => values[field])];
    });
    expect(rows).toEqual(TWO_SECONDS);
  });

  test("many events in many chunks", () => {
    const trace = new Trace(header());
    for (let i = 0; i < 3000; i++) {
      grow(trace, [
        ["pose", i / 10, i / 100, 0, 0],
        ["scan", i / 10, i / 100, 0, 0, [0, i / 20, 1, 2]],
      ]);
    }
    expect(trace.poseAt(200.05).x).toBeCloseTo(20.005, 9);
    expect(trace.scanAt(123.45)?.beams).toEqual([0, 61.7, 1, 2]);
  });
});

test.describe("what is refused", () => {
  const cases: [why: string, rows: unknown, message: string][] = [
    ["no list", { a: 1 }, "rows from 1 on: should be a list of events"],
    [
      "a row that is none",
      [["pose", 0, 1, 2, 3], 7],
      "row 2: an event is a list that begins with its kind",
    ],
    ["an empty row", [[]], "row 1: an event is a list that begins with its kind"],
    [
      "an unknown kind",
      [["smell", 0]],
      'row 1: unknown kind "smell"; known: pose, scan, layer, plot, print, note, line, led, beep, bump, fault, end',
    ],
    ["too few values", [["pose", 0, 1, 2]], "row 1: pose has 4 values (t, x, y, heading), not 3"],
    ["too many values", [["line", 0, 1, 2]], "row 1: line has 2 values (t, line), not 3"],
    [
      "a text for a number",
      [["pose", 0, "1", 2, 3]],
      'row 1: x of pose should be a number, not "1"',
    ],
    [
      "null for a number",
      [["plot", 0, "a", null]],
      "row 1: value of plot should be a number, not null",
    ],
    [
      "negative time",
      [["pose", -1, 0, 0, 0]],
      "row 1: t of pose should be a number from 0, not -1",
    ],
    [
      "time going back",
      [
        ["line", 2, 1],
        ["line", 1, 1],
      ],
      "row 2: time goes back from 2 to 1 s",
    ],
    [
      "beams that do not pair",
      [["scan", 0, 0, 0, 0, [1]]],
      "row 1: beams of scan should be a flat list of angle, distance pairs, not [1]",
    ],
    [
      "an unknown shape",
      [["layer", 0, "a", "red", "stars", 5, 0, 0, null]],
      'row 1: shape of layer should be one of dots, squares, line, text, not "stars"',
    ],
    [
      "half a point",
      [["layer", 0, "a", "red", "dots", 5, 0.5, 0, null]],
      "row 1: first of layer should be a whole number from 0, not 0.5",
    ],
    [
      "points that are not there",
      [["layer", 0, "a", "red", "dots", 5, 1, 1, null]],
      'row 1: the layer "a" wants 1 points from number 1, but the store has 1',
    ],
    [
      "too few texts",
      [["layer", 0, "a", "red", "text", 5, 0, 1, []]],
      'row 1: the layer "a" has 0 texts for 1 points',
    ],
    [
      "no texts",
      [["layer", 0, "a", "red", "text", 5, 0, 1, null]],
      'row 1: the layer "a" has no texts for 1 points',
    ],
    [
      "an unknown stream",
      [["print", 0, "stdlog", "a"]],
      'row 1: stream of print should be one of stdout, stderr, not "stdlog"',
    ],
    ["line 0", [["line", 0, 0]], "row 1: line of line should be a line number from 1, not 0"],
    [
      "a colour out of range",
      [["led", 0, 256, 0, 0]],
      "row 1: red of led should be a number from 0 to 255, not 256",
    ],
    [
      "an unknown status",
      [["end", 0, "won", ""]],
      'row 1: status of end should be one of finished, fault, stopped, limit, not "won"',
    ],
    [
      "anything after the end",
      [
        ["end", 1, "finished", ""],
        ["line", 1, 1],
      ],
      "row 2: line after the end of the run",
    ],
  ];
  for (const [why, rows, message] of cases) {
    test(why, () => {
      const trace = new Trace(header());
      const points = Int16Array.of(0, 0);
      const append = () => trace.append({ events: JSON.stringify(rows), points });
      expect(append).toThrow(TraceError);
      expect(append).toThrow(message);
      expect([trace.length, trace.duration, trace.bytes]).toEqual([0, 0, 0]);
    });
  }

  test("text that is not JSON", () => {
    const append = () => new Trace(header()).append({ events: "[", points: new Int16Array(0) });
    expect(append).toThrow(/^rows from 1 on: not JSON: /);
  });

  test("half a point in the store", () => {
    const append = () => new Trace(header()).append({ events: "[]", points: Int16Array.of(1) });
    expect(append).toThrow("row 1: the points do not come in pairs");
  });

  test("the row is counted over the whole run, and a refused chunk leaves no mark", () => {
    const trace = twoSeconds();
    expect(() => grow(trace, [["line", 3, 1]])).toThrow("row 22: line after the end of the run");
    const growing = traceOf([["line", 0, 1]]);
    expect(() =>
      grow(
        growing,
        [
          ["line", 1, 1],
          ["line", 1, -1],
        ],
        [1, 1],
      ),
    ).toThrow("row 3:");
    expect([growing.length, growing.duration]).toEqual([1, 0]);
  });

  test("more than the limit", () => {
    const trace = new Trace(header(), 1000);
    expect(() => grow(trace, [["print", 0, "stdout", "x".repeat(950)]])).toThrow(
      "the trace would grow beyond 0.001 MB",
    );
    expect(() => grow(trace, [["line", 0, 1]], Array(1000).fill(0))).toThrow(TraceError);
    grow(trace, [["print", 0, "stdout", "x".repeat(900)]]);
    expect(trace.consoleText(0)).toHaveLength(900);
  });
});

test.describe("files that are no runs", () => {
  const head = JSON.stringify(header());
  const many = 45_000_000;
  const files: Record<string, () => string> = {
    "45 million opening brackets": () => `${head}\n${"[".repeat(many)}`,
    "the same within a list": () => `${head}\n["pose",${"[".repeat(many)}`,
    "as many empty lists": () => `${head}\n[${"[],".repeat(many / 3)}[]]`,
    "as many records": () => `${head}\n${'{"a":'.repeat(many / 5)}`,
    "brackets in the header": () => `${head.slice(0, -1)},"more":${"[".repeat(many)}`,
    "45 million empty lines": () => `${head}\n${"\n".repeat(many)}`,
  };
  for (const [what, text] of Object.entries(files)) {
    test(`${what} are refused in words`, () => {
      expect(() => readTraceFile(text())).toThrow(TraceError);
    });
  }

  test("brackets in what a program printed are no brackets of the file", () => {
    const trace = traceOf([
      ["print", 0, "stdout", `${"[".repeat(50_000)}\\" {{"`],
      ["end", 0, "finished", "Finished."],
    ]);
    expect(readTraceFile(writeTraceFile(trace)).complete).toBe(true);
  });
});
