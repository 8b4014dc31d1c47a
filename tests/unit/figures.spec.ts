/** The live figures: their geometry against Python's, and what they show for a given state. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import {
  type Cell,
  cellAt,
  clearLength,
  crossed,
  endOfBeam,
  FAR_CM,
  passedByBresenham,
  passedBySteps,
} from "../../site/src/figures/beam/geometry.ts";
import { beamSentence, tally } from "../../site/src/figures/beam/says.ts";
import { EXAMPLES, onMat, passedBy, RULES, readingOf } from "../../site/src/figures/beam/scene.ts";
import {
  call,
  course,
  type Press,
  probability,
  SYSTEMS,
  type System,
  undoing,
} from "../../site/src/figures/evidence/cell.ts";
import { evidenceSentence } from "../../site/src/figures/evidence/says.ts";
import { LIVE_FIGURES } from "../../site/src/figures/figures.ts";

interface GoldenBeam {
  x: number;
  y: number;
  angle: number;
  reading: number;
  cell: number;
  clear: number;
  hit: [number, number] | null;
  end: [number, number];
  half: Cell[];
  whole: Cell[];
  bresenham: Cell[];
}

test("the beams are Python's, cell for cell", () => {
  const file = join(ROOT, "tests/golden/beams.json");
  const golden: { far: number; beams: GoldenBeam[] } = JSON.parse(readFileSync(file, "utf8"));
  expect(FAR_CM).toBe(golden.far);
  expect(golden.beams.length).toBeGreaterThan(50);
  for (const beam of golden.beams) {
    const { x, y, angle, reading, cell } = beam;
    const which = `from (${x}, ${y}) at ${angle} degrees, ${reading} cm, cells of ${cell} cm`;
    const start = { x, y };
    const clear = clearLength(reading, cell);
    const end = endOfBeam(start, angle, clear);
    expect(clear, which).toBeCloseTo(beam.clear, 9);
    expect(end.x, which).toBeCloseTo(beam.end[0], 5);
    expect(end.y, which).toBeCloseTo(beam.end[1], 5);
    expect(passedBySteps(start, angle, clear, cell, cell / 2), which).toEqual(beam.half);
    expect(passedBySteps(start, angle, clear, cell, cell), which).toEqual(beam.whole);
    expect(passedByBresenham(start, angle, clear, cell), which).toEqual(beam.bresenham);
    expect(reading < FAR_CM, which).toBe(beam.hit !== null);
    if (beam.hit) {
      const hit = endOfBeam(start, angle, reading);
      expect(
        [hit.x, hit.y].map((each) => Number(each.toFixed(4))),
        which,
      ).toEqual(beam.hit.map((each) => Number(each.toFixed(4))));
    }
  }
});

test("the cells that a way really crosses", () => {
  const way = (x0: number, y0: number, x1: number, y1: number): Cell[] =>
    crossed({ x: x0, y: y0 }, { x: x1, y: y1 }, 10).map(({ cell }) => cell);
  expect(way(5, 5, 5, 5)).toEqual([[0, 0]]);
  expect(way(5, 5, 35, 5)).toEqual([
    [0, 0],
    [1, 0],
    [2, 0],
    [3, 0],
  ]);
  expect(way(5, 25, 5, 5)).toEqual([
    [0, 2],
    [0, 1],
    [0, 0],
  ]);
  // Straight through the corners: the cells beside them are not touched.
  expect(way(5, 5, 25, 25)).toEqual([
    [0, 0],
    [1, 1],
    [2, 2],
  ]);
  expect(way(25, 25, 5, 5)).toEqual([
    [2, 2],
    [1, 1],
    [0, 0],
  ]);
  // A little beside the corner at (10, 10): its lower right cell is clipped.
  expect(way(5, 4, 25, 24)).toEqual([
    [0, 0],
    [1, 0],
    [1, 1],
    [2, 1],
    [2, 2],
  ]);
  // A grid line belongs to the upper and the right cell, at either end of the way.
  expect(way(5, 5, 20, 5)).toEqual([
    [0, 0],
    [1, 0],
    [2, 0],
  ]);
  expect(way(20, 5, 5, 5)).toEqual([
    [2, 0],
    [1, 0],
    [0, 0],
  ]);
  expect(way(25, 5, 20, 5)).toEqual([[2, 0]]);
});

test("how much of a way is in each cell adds up to the way", () => {
  const stretches = crossed({ x: 5, y: 4 }, { x: 25, y: 24 }, 10);
  const corner = stretches[1];
  expect(corner?.cm).toBeCloseTo(Math.SQRT2, 9);
  expect(stretches.reduce((sum, { cm }) => sum + cm, 0)).toBeCloseTo(Math.hypot(20, 20), 9);
});

test("whole-cell steps miss what half-cell steps find, and the words say how much", () => {
  const beam = EXAMPLES.slant;
  const [half, whole, line] = RULES.map((rule) => passedBy(rule, beam.start, readingOf(beam)));
  expect(whole?.missed.length).toBeGreaterThan(half?.missed.length ?? 0);
  expect(line?.cells).toHaveLength(new Set(line?.cells.map(String)).size);
  expect(tally(beam, "whole")).toBe(`${whole?.cells.length} cells, ${whole?.missed.length} missed`);
  expect(beamSentence(beam, "whole")).toMatch(
    /^The sensor reads 151 cm\. The floor counts as free for 141 cm, one cell short of the hit\. 14 looks, 10 cm apart, name 13 cells\. The beam crosses 6 more, for at most \d\.\d cm each\.$/,
  );
});

test("along a row nothing is missed, and a reading of nothing has no hit", () => {
  for (const rule of RULES) {
    expect(passedBy(rule, EXAMPLES.row.start, readingOf(EXAMPLES.row)).missed).toEqual([]);
  }
  const far = readingOf(EXAMPLES.far);
  expect(far.cm).toBeGreaterThan(FAR_CM);
  expect([far.clear, far.hit]).toEqual([FAR_CM, null]);
  expect(beamSentence(EXAMPLES.far, "half")).toContain("there is no hit");
  const near = { start: { x: 55, y: 55 }, end: { x: 62, y: 55 } };
  expect(readingOf(near)).toMatchObject({ cm: 7, clear: 0, hit: cellAt(near.end, 10) });
  expect(beamSentence(near, "half")).toContain("no floor counts as free");
  expect(beamSentence({ start: near.start, end: near.start }, "bresenham")).toContain("1 cell");
});

test("what is dragged stays on the mat", () => {
  expect(onMat({ x: -40, y: 500 })).toEqual({ x: 5, y: 115 });
  expect(onMat({ x: 31.4, y: 60 })).toEqual({ x: 31, y: 60 });
});

/** Log odds after these presses with a system's numbers. */
function after(system: System, ...presses: Press[]): number {
  return course(SYSTEMS[system], presses).at(-1) ?? Number.NaN;
}
const hits = (times: number): Press => ({ what: "hit", times });
const passes = (times: number): Press => ({ what: "pass", times });

test("evidence adds up, is held at the clamp, and takes so many of the other kind to undo", () => {
  expect(after("ours", hits(3), passes(2))).toBeCloseTo(1.75, 9);
  expect(after("ours", hits(10))).toBe(8);
  expect(after("ours", passes(30))).toBe(-8);
  expect(undoing(SYSTEMS.ours, 8)).toEqual(passes(20));
  expect(undoing(SYSTEMS.ours, -0.4)).toEqual(hits(1));
  expect(undoing(SYSTEMS.ours, after("ours", hits(8), passes(17)))).toBeNull();
  expect(call(SYSTEMS.ours, 1)).toBe("unknown");
  expect(call(SYSTEMS.ours, 1.01)).toBe("occupied");
  expect(call(SYSTEMS.ours, -1.01)).toBe("free");
});

test("the systems' numbers: hits to the clamp, and passes to undo it", () => {
  const toClamp = (system: System): number => {
    const values = course(SYSTEMS[system], [hits(100)]);
    return values.indexOf(after(system, hits(100)));
  };
  const undone = (system: System): number | undefined =>
    undoing(SYSTEMS[system], after(system, hits(100)))?.times;
  expect([toClamp("ours"), undone("ours")]).toEqual([10, 20]);
  expect([toClamp("octomap"), undone("octomap")]).toEqual([5, 9]);
  expect([toClamp("cartographer"), undone("cartographer")]).toEqual([11, 55]);
  expect(probability(after("octomap", hits(1)))).toBeCloseTo(0.7, 9);
  expect(probability(after("cartographer", passes(100)))).toBeCloseTo(0.1, 9);
  // No more hits are added at 50; the last one may have gone over it.
  expect(after("hector", hits(100))).toBeCloseTo(23 * Math.log(9), 9);
  expect(after("hector", passes(100))).toBeCloseTo(100 * Math.log(0.4 / 0.6), 9);
});

test("the words of the evidence", () => {
  const { ours } = SYSTEMS;
  expect(evidenceSentence(ours, [])).toContain("No evidence yet");
  expect(evidenceSentence(ours, [hits(3), passes(2)])).toBe(
    "3 hits and 2 passes come to log odds of 1.75, a probability of 0.852: occupied. 5 passes in a row would undo it.",
  );
  expect(evidenceSentence(ours, [passes(30)])).toContain("That is as far as it goes.");
  expect(evidenceSentence(ours, [hits(8), passes(17)])).toContain("is even");
});

test("a figure as it is built is complete and its controls wait for the script", () => {
  expect(Object.keys(LIVE_FIGURES)).toEqual(["beam", "evidence"]);
  for (const [name, html] of Object.entries(LIVE_FIGURES)) {
    expect(html).toMatch(new RegExp(`^<bugbot-${name} class="live-figure"><`));
    expect(html).toContain('role="img"');
    expect(html).not.toMatch(/\n\s*\n|undefined|NaN/);
    expect(html).not.toMatch(/tabindex|role="(slider|status)"/);
    const controls = html.match(/<(button|select|fieldset)\b[^>]*>/g) ?? [];
    expect(controls.length).toBeGreaterThan(2);
    for (const control of controls) expect(control).toContain("disabled");
  }
});
