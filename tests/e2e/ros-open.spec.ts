/** Maps that other programs have made: what opens, and what is said of it. */
import { crc32, deflateSync } from "node:zlib";
import { zip } from "../../site/build/zip.mjs";
import type { App } from "./app.ts";
import { expect, test } from "./fixtures.ts";

test.slow();

const yaml = (image: string, resolution = 0.05, free = 0.196, x = 0): string =>
  `image: ${image}\nresolution: ${resolution}\norigin: [${x}, 0, 0]\nnegate: 0\n` +
  `occupied_thresh: 0.65\nfree_thresh: ${free}\n`;

const pgm = (side: number, grey: (i: number) => number): Buffer =>
  Buffer.concat([
    Buffer.from(`P5\n${side} ${side}\n255\n`),
    Buffer.from(Uint8Array.from({ length: side * side }, (_, i) => grey(i))),
  ]);

/** A PNG of greys whose rows all have the last of the filters. */
function png(side: number): Buffer {
  const rows = Buffer.alloc(side * (side + 1), 0);
  for (let y = 0; y < side; y++) rows[y * (side + 1)] = 4;
  rows[1] = 254; // all others are guessed from it
  const chunk = (name: string, data: Buffer): Buffer => {
    const body = Buffer.concat([Buffer.from(name), data]);
    const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(data.length);
    sum.writeUInt32BE(crc32(body));
    return Buffer.concat([length, body, sum]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(side, 0);
  header.writeUInt32BE(side, 4);
  header[8] = 8;
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]),
    chunk("IHDR", header),
    chunk("IDAT", deflateSync(rows)),
    chunk("IEND", Buffer.alloc(0)),
  ]);
}

const archive = (files: Record<string, string | Buffer>): Buffer =>
  zip(Object.entries(files).map(([path, data]) => ({ path, data: Buffer.from(data) })));

const open = (app: App, files: Record<string, string | Buffer>): Promise<void> =>
  app.openFile("Open a ROS map", "map.zip", archive(files));

test("a Mac’s archive opens, and what is doubtful about a map is told", { tag: "@once" }, async ({
  app,
  page,
}) => {
  await app.openLab("world=empty");
  const image = pgm(40, (i) => [254, 205, 0][i % 3] ?? 0);
  await open(app, {
    "map/map.yaml": yaml("map.pgm"),
    "__MACOSX/map/._map.yaml": Buffer.from([0, 5, 22, 7]),
    "map/map.pgm": image,
    "__MACOSX/map/._map.pgm": Buffer.from([0, 5, 22, 7]),
    "map/.DS_Store": "Bud1",
  });
  await expect(app.status).toContainText("map/map.yaml lies on the mat now");
  await expect(app.status).not.toContainText("205");

  // The trap of the lesson: unknown cells become floor.
  await open(app, { "trap.yaml": yaml("map.pgm", 0.05, 0.25), "map.pgm": image });
  await expect(app.status).toContainText(
    "the grey 205, which most programs write for unknown, is read as free floor (its p is 0.196): 533 cells. A free_thresh of 0.196 keeps them unknown.",
  );
  await expect(page.getByRole("group", { name: "Shown on the mat" })).toContainText("grey 205");

  // Half of it lies beyond the edge.
  await open(app, { "half.yaml": yaml("map.pgm", 0.05, 0.196, -1), "map.pgm": image });
  await expect(app.status).toContainText(
    "Only a part of it is shown: the map covers x = -100 to 100 and y = 0 to 200 cm",
  );
  await open(app, { "off.yaml": yaml("map.pgm", 0.05, 0.196, 5), "map.pgm": image });
  await expect(app.status).toContainText("none of it is on the mat: the map covers x = 500 to 700");

  await open(app, {
    "a/map.yaml": yaml("map.pgm"),
    "a/map.pgm": image,
    "b/map.yaml": yaml("map.pgm"),
  });
  await expect(app.status).toContainText(
    "choose one map at a time: there are a/map.yaml, b/map.yaml",
  );
});

test("a map of four million cells opens, as PGM and as PNG", { tag: "@once" }, async ({ app }) => {
  await app.openLab("world=empty");
  await open(app, { "wide.yaml": yaml("wide.pgm", 0.001), "wide.pgm": pgm(2000, () => 254) });
  await expect(app.status).toContainText("wide.yaml lies on the mat now");
  const middle = () =>
    app.view.evaluate((canvas: HTMLCanvasElement) => [
      ...(canvas.getContext("2d")?.getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data ??
        []),
    ]);
  expect(await middle()).toEqual([158, 202, 225, 255]);
  await open(app, { "tall.yaml": yaml("tall.png", 0.001), "tall.png": png(2000) });
  await expect(app.status).toContainText("tall.yaml lies on the mat now");
  expect(await middle()).toEqual([158, 202, 225, 255]);
});
