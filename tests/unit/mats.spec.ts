/** Mats that people make: the rules of their files, their shapes, their steps, and what is kept. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { filesBelow, ROOT } from "../../site/build/files.mjs";
import { readDraft, readWorld, WorldError } from "../../site/src/page/mats/check-world.ts";
import { History } from "../../site/src/page/mats/history.ts";
import { checkMat } from "../../site/src/page/mats/mat-checks.ts";
import { MatDesk } from "../../site/src/page/mats/mat-desk.ts";
import {
  linkToMat,
  matFile,
  matIn,
  readMatFile,
  sameMat,
} from "../../site/src/page/mats/mat-file.ts";
import { handlePlaces } from "../../site/src/page/mats/mat-picture.ts";
import { OwnMats } from "../../site/src/page/mats/own-mats.ts";
import { isOwnMat } from "../../site/src/page/mats/own-name.ts";
import { ownStarter } from "../../site/src/page/mats/own-starter.ts";
import { reach } from "../../site/src/page/mats/room.ts";
import {
  copyOf,
  drawn,
  grown,
  headingTo,
  kindOf,
  movedTo,
  nudged,
  resized,
} from "../../site/src/page/mats/shapes.ts";
import { pack, packedIn } from "../../site/src/page/share.ts";
import { ProgramStore } from "../../site/src/page/storage.ts";
import type { World } from "../../site/src/trace/events.ts";

const BOX = { x: 10, y: 20, width: 30, height: 40, name: "box" };
const MAT: World = {
  name: "own_abc123",
  title: "Büro 2",
  description: "For a try.",
  obstacles: [BOX],
  start: { x: 100, y: 100, heading: 90 },
};

/** A wall across the mat with a gap of so many cm in the middle; the robot stands below it. */
const walled = (gapCm: number): World => ({
  ...MAT,
  obstacles: [
    { x: 0, y: 110, width: 100 - gapCm / 2, height: 8, name: "wall" },
    { x: 100 + gapCm / 2, y: 110, width: 100 - gapCm / 2, height: 8, name: "wall" },
  ],
  start: { x: 100, y: 25, heading: 0 },
});

function device(): { store: ProgramStore; kept: Map<string, string> } {
  const kept = new Map<string, string>();
  const storage = {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, text: string) => kept.set(key, text),
    removeItem: (key: string) => kept.delete(key),
  };
  return { store: new ProgramStore(() => storage as unknown as Storage), kept };
}

interface Agreed {
  what: string;
  world: Record<string, unknown>;
  times?: Record<string, number>;
  refused: string | null;
}

test.describe("the same worlds as in tests/py/bugbot/test_worlds.py are taken and refused", () => {
  const agreed: Agreed[] = JSON.parse(readFileSync(join(ROOT, "tests/golden/worlds.json"), "utf8"));
  for (const { what, world, times = {}, refused } of agreed) {
    test(what, () => {
      for (const [field, count] of Object.entries(times)) {
        const one = world[field];
        world[field] = Array.isArray(one) ? Array(count).fill(one[0]) : String(one).repeat(count);
      }
      const answer = (): string | null => {
        try {
          readWorld(world);
          return null;
        } catch (error) {
          expect(error).toBeInstanceOf(WorldError);
          return (error as Error).message.split("; it got")[0] ?? "";
        }
      };
      expect(answer()).toBe(refused);
    });
  }
});

test("the worlds that come with the site and the lessons are taken as they are", () => {
  const folders = ["py/bugbot/worlds", "lessons"].map((path) => join(ROOT, path));
  let read = 0;
  for (const folder of folders) {
    const isWorld = (path: string): boolean => /(^|worlds\/)[^/]+\.json$/.test(path);
    for (const path of filesBelow(folder, isWorld)) {
      const data = JSON.parse(readFileSync(join(folder, path), "utf8"));
      if (!("obstacles" in data)) continue;
      expect(readWorld(data), path).toMatchObject({ title: data.title, start: data.start });
      expect(isOwnMat(data.name), `${path} has the name of a mat made on a device`).toBe(false);
      read += 1;
    }
  }
  expect(read).toBeGreaterThan(15);
});

test("a mat in the making may have its robot in a wall, but nothing off the mat", () => {
  const inBox = { ...MAT, start: { x: 20, y: 30, heading: 0 } };
  expect(readDraft(inBox)).toEqual(inBox);
  expect(() => readDraft({ ...MAT, start: { x: 300, y: 30, heading: 0 } })).toThrow(WorldError);
  expect(checkMat(inBox)).toMatchObject({ kind: "fault", text: /stands in the box.*5\.0 cm/ });
});

test("what is drawn lies on the grid and on the mat, whichever way the corner is dragged", () => {
  expect(drawn({ x: 41, y: 62 }, { x: 12, y: 8 }, 5)).toEqual({
    x: 10,
    y: 10,
    width: 30,
    height: 50,
  });
  expect(drawn({ x: 190, y: 190 }, { x: 260, y: 230 }, 5)).toMatchObject({ width: 10, height: 10 });
  expect(drawn({ x: 41.4, y: 62 }, { x: 44.6, y: 65 }, 0)).toMatchObject({ x: 41, width: 4 });
  expect(drawn({ x: 41, y: 62 }, { x: 42, y: 90 }, 5)).toBeNull();
});

test("things are moved, made larger and copied within the mat", () => {
  expect(movedTo(BOX, 180, -4)).toMatchObject({ x: 170, y: 0, width: 30, height: 40 });
  expect(resized(BOX, "w", { x: 55, y: 0 })).toMatchObject({ x: 39, width: 1, y: 20, height: 40 });
  expect(resized(BOX, "ne", { x: 300, y: 70 })).toMatchObject({ x: 10, width: 190, height: 50 });
  expect(copyOf({ ...BOX, x: 170, y: 0 })).toMatchObject({ x: 160, y: 10 });
  expect(nudged(MAT, 0, 1, -5).obstacles[0]).toMatchObject({ x: 11, y: 15 });
  expect(nudged(MAT, "robot", 500, 0).start).toEqual({ x: 195, y: 100, heading: 90 });
  expect(grown(MAT, "robot", -1, 0).start.heading).toBe(75);
  expect(grown(MAT, 0, -1, 0).obstacles[0]).toMatchObject({ x: 10, width: 29 });
  expect(headingTo({ x: 100, y: 100 }, { x: 50, y: 101 }, 15)).toBe(270);
  expect([kindOf({ x: 0, y: 0, width: 8, height: 24 }), kindOf(BOX)]).toEqual(["wall", "box"]);
});

test("handles are off the sides, stay in reach at the mat's edge, and crowd nothing small", () => {
  const places = handlePlaces({ ...BOX, x: 0, y: 0, width: 8, height: 60 }, 2, false);
  expect(places.map(({ side }) => side)).toEqual(["n", "s", "e", "w"]);
  expect(places.find(({ side }) => side === "e")?.at).toEqual({ x: 13, y: 30 });
  expect(places.find(({ side }) => side === "w")?.at).toEqual({ x: -4, y: 30 });
  expect(handlePlaces(BOX, 4, false)).toHaveLength(8);
});

test("a passage is one only if the robot fits through", () => {
  expect(reach(walled(20))).toBe(1);
  const shut = reach(walled(8));
  expect(shut).toBeGreaterThan(0.5);
  expect(shut).toBeLessThan(0.6);
  expect(checkMat(walled(20))).toMatchObject({ kind: "fine" });
  expect(checkMat(walled(8))).toMatchObject({
    kind: "note",
    text: /^The robot can drive to 5\d % /,
  });
  expect(checkMat({ ...MAT, obstacles: [] }).text).toContain("bare");
  const cage = [
    { x: 85, y: 85, width: 30, height: 8, name: "bar" },
    { x: 85, y: 107, width: 30, height: 8, name: "bar" },
    { x: 85, y: 93, width: 8, height: 14, name: "bar" },
    { x: 107, y: 93, width: 8, height: 14, name: "bar" },
  ];
  expect(checkMat({ ...MAT, obstacles: cage }).text).toContain("shut in");
});

test("a movement of many changes is one step; a movement given up is none", () => {
  const history = new History(0);
  for (const state of [1, 2, 3]) history.change(state, "drag 1");
  history.settle();
  history.change(4, "drag 1");
  expect([history.undo(), history.now, history.undo(), history.now]).toEqual([true, 3, true, 0]);
  expect([history.undo(), history.redo(), history.now]).toEqual([false, true, 3]);
  history.change(9, "drag 2");
  history.abandon("drag 2");
  expect([history.now, history.canRedo]).toEqual([3, false]);
});

test("a mat is kept as it is changed, found again, deleted and brought back", () => {
  const { store } = device();
  const desk = new MatDesk(new OwnMats(store));
  expect(desk.mats).toEqual([]);
  desk.addBox();
  desk.nudge(1, 0);
  desk.nudge(1, 0);
  desk.flush();
  const { name } = desk.world;
  expect(isOwnMat(name)).toBe(true);
  const again = new MatDesk(new OwnMats(store), name);
  expect(again.world).toEqual(desk.world);

  desk.undo();
  expect(desk.world.obstacles[0]?.x).toBe(90);
  desk.undo();
  expect([desk.world.obstacles.length, desk.canUndo]).toEqual([0, false]);
  desk.redo();
  desk.redo();
  expect(desk.world).toEqual(again.world);

  desk.discard(name);
  expect([desk.mats.length, desk.world.name === name]).toEqual([0, false]);
  desk.said.undo?.();
  expect(desk.world).toEqual(again.world);
});

test("another tab's change to the same mat is a step that undo takes back", () => {
  const { store } = device();
  const [mine, theirs] = [new OwnMats(store), new OwnMats(store)];
  mine.keep(MAT);
  const desk = new MatDesk(mine, MAT.name);
  theirs.keep({ ...MAT, title: "Theirs" });
  desk.followElsewhere();
  expect(desk.world.title).toBe("Theirs");
  desk.undo();
  expect(desk.world.title).toBe("Büro 2");
});

test("whatever lies in the record, what is sound in it is found", () => {
  const { store, kept } = device();
  for (const text of ["{", "null", '{"mats":7}']) {
    kept.set("bugbot:mats", text);
    expect(new OwnMats(store).all()).toEqual([]);
  }
  const stranger = { ...MAT, name: "doorway" };
  const inBox = { ...MAT, name: "own_inabox", start: { x: 20, y: 30, heading: 0 } };
  const mats = [
    null,
    { at: 1, world: {} },
    ...[stranger, inBox, MAT].map((world) => ({ at: 1, world })),
  ];
  kept.set("bugbot:mats", JSON.stringify({ format: 1, mats }));
  const own = new OwnMats(store);
  expect(own.all().map(({ world }) => world.name)).toEqual(["own_inabox", "own_abc123"]);
  expect(own.worlds()).toEqual([MAT]);
});

test("a file has the name of a lesson's world, and comes back as it was", async () => {
  const { name, text } = matFile(MAT, []);
  expect([name, JSON.parse(text).name]).toEqual(["buro-2.json", "buro-2"]);
  expect(text).toContain('    { "x": 10, "y": 20, "width": 30, "height": 40, "name": "box" }\n');
  const read = await readMatFile(new File([text], name));
  expect(sameMat(read, MAT)).toBe(true);
  expect(matFile({ ...MAT, title: "Doorway" }, ["doorway"]).name).toBe("doorway-of-mine.json");
  expect(matFile({ ...MAT, title: "世界" }, []).name).toBe("mat.json");
  const dark = { ...MAT, camera: false };
  expect(readWorld(JSON.parse(matFile(dark, []).text)).camera).toBe(false);
  const slips = { ...dark, odometry: { drift_deg_s: -0.3, slip: 0.05 } };
  expect(readWorld(JSON.parse(matFile(slips, []).text)).odometry).toEqual(slips.odometry);
});

test("a file that holds no mat is refused in plain words", async () => {
  const refusal = (content: string, name = "room.json") =>
    readMatFile(new File([content], name)).then(
      () => "opened",
      (error: Error) => error.message,
    );
  expect(await refusal("[")).toBe("room.json is not a mat, or it is damaged: it is not JSON.");
  expect(await refusal("[".repeat(90_000))).toContain("it is not JSON");
  expect(await refusal("{}")).toContain("name is missing; add it");
  expect(await refusal("x".repeat(100_001))).toContain("more than 100 kB");
  expect(await refusal("\0")).toContain("could not be read as text");
});

test("a link carries the mat, with a program or without; a broken one is refused", async () => {
  const link = new URL(
    await linkToMat("https://a.school/lab/", MAT, { seed: 7, program: "x = 1\n" }),
  );
  expect([link.search, link.href.length < 400]).toEqual(["?seed=7", true]);
  expect(packedIn(link.hash)).not.toBeNull();
  const mat = await matIn(packedIn(link.hash, "mat") ?? "");
  expect([mat.name, sameMat(mat, MAT)]).toEqual(["buro-2", true]);
  expect(new URL(await linkToMat("https://a.school/lab/", MAT)).search).toBe("");

  const refusal = async (text: string | Promise<string>) =>
    matIn(await text).then(
      () => "opened",
      (error: Error) => `${error.name}: ${error.message}`,
    );
  expect(await refusal("abc")).toMatch(/^ShareError: The mat in this link cannot be read/);
  expect(await refusal(pack("x".repeat(5_000_000)))).toMatch(/^ShareError: .*more than 100 kB/);
  expect(await refusal(pack("{"))).toMatch(/^ShareError: .*it is not JSON/);
  const hostile = JSON.stringify({ ...MAT, start: { x: 20, y: 30, heading: 0 } });
  expect(await refusal(pack(hostile))).toMatch(/^ShareError: .*too near obstacles\[0\], the box/);
});

test("the program for a mat of one's own knows its start and its obstacles", () => {
  const demo = "lessons/occupancy-grid-mapping/programs/demo-1-from-one-spot.py";
  const source = readFileSync(join(ROOT, demo), "utf8");
  const program = ownStarter(source, MAT);
  expect(program).toContain("\nSTART = (100, 100)  # ");
  expect(program).toContain("\nREAL = [(10, 20, 30, 40)]\n");
  expect(program).not.toContain("130, 70, 8, 70");
});
