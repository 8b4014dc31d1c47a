/** The parts of the views that need no page: camera, cells, cursor, words. */
import { expect, test } from "@playwright/test";
import { cellOf } from "../../site/src/trace/frames.ts";
import { aheadOf, nearestTo, obstacleAt, obstacleIn } from "../../site/src/trace/truth.ts";
import { Camera } from "../../site/src/views/overhead/camera.ts";
import { cellSizeOf, DrawnCells } from "../../site/src/views/overhead/cells.ts";
import { CellCursor } from "../../site/src/views/overhead/cursor.ts";
import { describeMoment, explainCell } from "../../site/src/views/overhead/describe.ts";
import { Inspector } from "../../site/src/views/overhead/inspector.ts";
import { traceOf, twoSeconds, WORLD } from "./traces.ts";

test.describe("camera", () => {
  test("x grows to the right of the canvas, y to its top", () => {
    const camera = new Camera(400, 400, 1);
    expect(camera.x(200)).toBeGreaterThan(camera.x(0));
    expect(camera.y(200)).toBeLessThan(camera.y(0));
    expect(camera.x(200) - camera.x(0)).toBeCloseTo(200 * camera.scale, 9);
    expect(camera.y(0) - camera.y(200)).toBeCloseTo(200 * camera.scale, 9);
  });

  test("the whole mat is on the canvas, whatever its shape", () => {
    for (const [width, height] of [
      [400, 400],
      [900, 300],
      [300, 900],
    ] as const) {
      const camera = new Camera(width, height, 1);
      expect(camera.x(0)).toBeGreaterThan(0);
      expect(camera.x(200)).toBeLessThan(width);
      expect(camera.y(200)).toBeGreaterThan(0);
      expect(camera.y(0)).toBeLessThan(height);
    }
  });

  test("a pointer finds the point that was drawn there, at any ratio of pixels", () => {
    for (const ratio of [1, 1.5, 3]) {
      const camera = new Camera(357, 411, ratio);
      const { x, y } = camera.toMat(camera.x(12.5) / ratio, camera.y(187.5) / ratio);
      expect(x).toBeCloseTo(12.5, 9);
      expect(y).toBeCloseTo(187.5, 9);
    }
  });

  test("twice the ratio is twice the pixels", () => {
    expect(new Camera(400, 300, 2)).toMatchObject({ width: 800, height: 600, ratio: 2 });
    expect(new Camera(400, 400, 2).scale).toBeCloseTo(2 * new Camera(400, 400, 1).scale, 9);
    expect(new Camera(400, 400, 2).px(3)).toBe(6);
  });
});

test.describe("cells", () => {
  test("the lower and left edges are the cell's own; beyond the mat there is none", () => {
    expect(cellOf(10, 15, 5)).toEqual({ x: 10, y: 15, size: 5 });
    expect(cellOf(14.99, 19.99, 5)).toEqual({ x: 10, y: 15, size: 5 });
    expect([cellOf(200, 5, 5), cellOf(5, -0.1, 5)]).toEqual([null, null]);
  });

  const points = [2.5, 2.5, 7.5, 2.5, 7.5, 2.5];
  const layer = (name: string, size: number, first: number, count: number, shape = "squares") => [
    "layer",
    0,
    name,
    "red",
    shape,
    size,
    first,
    count,
    null,
  ];

  test("their size is that of the first squares drawn, else 5 cm", () => {
    const size = (...rows: unknown[][]) => cellSizeOf(traceOf(rows, points).layersAt(0));
    expect(size()).toBe(5);
    expect(size(layer("a", 9, 0, 1, "dots"))).toBe(5);
    expect(size(layer("a", 20, 0, 1), layer("b", 10, 0, 1))).toBe(20);
    expect(size(layer("a", 20, 0, 0), layer("b", 10, 0, 1))).toBe(10);
    expect(size(layer("a", 0.01, 0, 1))).toBe(5);
  });

  test("each belongs to the topmost layer with a square there", () => {
    const trace = traceOf([layer("free", 5, 0, 2), layer("goal", 5, 2, 1)], points);
    const cells = new DrawnCells(trace, trace.layersAt(0));
    expect(cells.nameAt(0, 0)).toBe("free");
    expect(cells.nameAt(9.9, 4.9)).toBe("goal");
    expect(cells.nameAt(10, 0)).toBeNull();
    expect(cells.nameAt(-1, 0)).toBeNull();
    expect([cells.bare, cells.any]).toEqual([1598, true]);
  });

  test("two maps are compared cell by cell, if their cells are of one size", () => {
    const cellsOf = (...rows: unknown[][]) => {
      const trace = traceOf(rows, points);
      return new DrawnCells(trace, trace.layersAt(0));
    };
    const both = cellsOf(layer("free", 5, 0, 2));
    expect(both.differencesFrom(cellsOf(layer("free", 5, 0, 1)))).toEqual([
      { x: 5, y: 0, size: 5 },
    ]);
    expect(both.differencesFrom(both)).toEqual([]);
    expect(both.differencesFrom(cellsOf(layer("free", 10, 0, 1)))).toBeNull();
  });
});

test.describe("the cell cursor", () => {
  const start = { x: 100, y: 100 };

  test("begins where the robot is, and moves by cells of the size that is drawn", () => {
    const cursor = new CellCursor();
    expect(cursor.cell(5)).toBeNull();
    expect(cursor.key("ArrowUp", false, 5, start)).toBe(true);
    expect(cursor.cell(5)).toEqual({ x: 100, y: 100, size: 5 });
    cursor.key("ArrowUp", false, 5, start);
    cursor.key("ArrowLeft", false, 5, start);
    expect(cursor.cell(5)).toEqual({ x: 95, y: 105, size: 5 });
    cursor.key("ArrowRight", true, 5, start);
    expect(cursor.cell(5)).toEqual({ x: 120, y: 105, size: 5 });
    cursor.key("ArrowDown", false, 20, start);
    expect(cursor.cell(20)).toEqual({ x: 120, y: 80, size: 20 });
  });

  test("stays on the mat", () => {
    const cursor = new CellCursor();
    cursor.pick({ x: 1, y: 199 }, 5);
    cursor.key("ArrowLeft", true, 5, start);
    cursor.key("ArrowUp", true, 5, start);
    expect(cursor.cell(5)).toEqual({ x: 0, y: 195, size: 5 });
  });

  test("leaves other keys alone", () => {
    expect(new CellCursor().key(" ", false, 5, start)).toBe(false);
    expect(new CellCursor().key("a", false, 5, start)).toBe(false);
  });

  test("the pointer's cell goes before the picked one, which comes back", () => {
    const cursor = new CellCursor();
    cursor.pick({ x: 12, y: 12 }, 5);
    cursor.hover({ x: 52, y: 52 });
    expect(cursor.cell(5)).toEqual({ x: 50, y: 50, size: 5 });
    cursor.hover({ x: 300, y: 52 });
    expect(cursor.cell(5)).toBeNull();
    cursor.hover(null);
    expect(cursor.cell(5)).toEqual({ x: 10, y: 10, size: 5 });
    cursor.pick({ x: 14, y: 14 }, 5);
    expect(cursor.cell(5)).toBeNull();
  });
});

test.describe("what is really there", () => {
  test("at a point, in a cell, nearest, and ahead", () => {
    expect(obstacleAt(WORLD, 130, 70)?.name).toBe("post");
    expect(obstacleAt(WORLD, 129.9, 100)).toBeNull();
    expect(obstacleIn(WORLD, { x: 120, y: 100, size: 20 })?.name).toBe("post");
    expect(obstacleIn(WORLD, { x: 125, y: 100, size: 5 })).toBeNull();
    expect(nearestTo(WORLD, 127.5, 100)).toEqual({ name: "post", cm: 2.5 });
    expect(nearestTo(WORLD, 127, 66)).toEqual({ name: "post", cm: 5 });
    expect(nearestTo(WORLD, 10, 100)).toEqual({ name: "edge of the mat", cm: 10 });
  });

  test("straight ahead, from the robot's centre", () => {
    const ahead = (x: number, y: number, heading: number) =>
      aheadOf(WORLD, { t: 0, x, y, heading });
    expect(ahead(100, 100, 90).name).toBe("post");
    expect(ahead(100, 100, 90).cm).toBeCloseTo(30, 9);
    expect(ahead(100, 100, 270)).toEqual({ name: "edge of the mat", cm: 100 });
    expect(ahead(100, 100, 0).cm).toBeCloseTo(100, 9);
    expect(ahead(120, 60, 45).cm).toBeCloseTo(10 * Math.SQRT2, 9);
    expect(ahead(150, 100, 90).name).toBe("edge of the mat");
  });
});

test.describe("in words", () => {
  test("a moment", () => {
    const trace = twoSeconds();
    expect(describeMoment(trace, 0, trace.layersAt(0))).toBe(
      "robot at (100, 100) cm, heading 350°; 2 free; nothing within 40 cm ahead",
    );
    const facing = traceOf([["pose", 0, 100, 100, 90]]);
    expect(describeMoment(facing, 0, [])).toBe(
      "robot at (100, 100) cm, heading 90°; nothing drawn; post 30 cm ahead",
    );
  });

  test("a cell: as drawn, as it is, and what the beams say", () => {
    const trace = twoSeconds();
    const none = { passed: 0, ended: 0, close: 0, last: null };
    expect(explainCell(trace, { x: 125, y: 100, size: 5 }, "walls", none)).toEqual({
      title: "Cell (127.5, 102.5) cm",
      text: "is drawn as walls; really floor, 2.5 cm from the post. No beam of this run has touched it so far.",
    });
    expect(explainCell(trace, { x: 120, y: 100, size: 20 }, null, none).text).toMatch(
      /^is bare mat; really the post\. /,
    );
    expect(explainCell(trace, { x: 110, y: 60, size: 22 }, null, none).text).toMatch(
      /^is bare mat; really floor, with some of the post in it\. /,
    );
    const last = { t: 1.23, x: 0, y: 0, endX: 0, endY: 0, reading: 27.41, did: "ended" as const };
    expect(
      explainCell(trace, { x: 125, y: 100, size: 5 }, null, { passed: 1, ended: 9, close: 0, last })
        .text,
    ).toMatch(
      /\. So far 1 beam passed through it and 9 ended in it; the last, at 1\.2 s, read 27\.4 cm and ended here\.$/,
    );
    const close = { passed: 0, ended: 2, close: 3, last: { ...last, did: "close" as const } };
    expect(explainCell(trace, { x: 125, y: 100, size: 5 }, null, close).text).toMatch(
      /So far 0 beams passed through it and 2 ended in it; 3 more ended just behind it, and by the lessons' rule say nothing about it; the last, at 1\.2 s, read 27\.4 cm and ended just behind it\.$/,
    );
  });
});

test("the inspector leaves hidden layers out of everything but the list", () => {
  const trace = twoSeconds();
  const inspector = new Inspector();
  const cursor = new CellCursor();
  cursor.pick({ x: 102.5, y: 102.5 }, 5);
  const seen = inspector.look(trace, 2, cursor, twoSeconds());
  expect(seen.cells.nameAt(102.5, 102.5)).toBe("free");
  expect(seen.different).toEqual([]);
  expect(seen.evidence?.passed).toBeGreaterThan(0);
  inspector.toggle("free");
  const hidden = inspector.look(trace, 2, cursor, null);
  expect(hidden.layers.map(({ name }) => name)).toEqual(["free", "walls", "names"]);
  expect(hidden.visible.map(({ name }) => name)).toEqual(["walls", "names"]);
  expect(hidden.cells.nameAt(102.5, 102.5)).toBeNull();
  expect(hidden.different).toBeNull();
  inspector.toggle("free");
  expect(inspector.look(trace, 2, cursor, null).visible).toHaveLength(3);
});
