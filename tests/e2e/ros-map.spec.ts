/** The map one can take away: downloaded, read by another reader, opened again on the mat. */
import type { Locator } from "@playwright/test";
import { expect, test } from "./fixtures.ts";
import { readRosMap, unzip } from "./ros-reader.ts";

test.slow();

interface Lab extends HTMLElement {
  run(): Promise<{ layers: Record<string, { size: number; points: [number, number][] }> }>;
  seek(seconds: number): void;
}

/** What the run's outcome says of each cell: 0 free, 100 occupied, -1 unknown. */
function cellsOf(layers: Awaited<ReturnType<Lab["run"]>>["layers"]): number[] {
  const cells = new Array<number>(40 * 40).fill(-1);
  for (const [name, value] of [
    ["free", 0],
    ["occupied", 100],
  ] as const) {
    for (const [x, y] of layers[name]?.points ?? []) {
      cells[Math.floor(y / 5) * 40 + Math.floor(x / 5)] = value;
    }
  }
  return cells;
}

/** Red, green, blue in the middle of a cell of 5 cm on the overhead view. */
function colourAt(view: Locator, cell: number): Promise<number[]> {
  return view.evaluate(
    (canvas: HTMLCanvasElement, [column, row]) => {
      // The mat and its walls, 206 cm, fill the canvas but for the scale: 30 and 22 pixels.
      const box = canvas.getBoundingClientRect();
      const across = box.width - 32;
      const up = box.height - 24;
      const scale = Math.min(across, up) / 206;
      const left = 30 + (across - 206 * scale) / 2 + 3 * scale;
      const bottom = box.height - 22 - (up - 206 * scale) / 2 - 3 * scale;
      const ratio = canvas.width / box.width;
      const x = (left + ((column ?? 0) + 0.4) * 5 * scale) * ratio;
      const y = (bottom - ((row ?? 0) + 0.6) * 5 * scale) * ratio;
      return [...(canvas.getContext("2d")?.getImageData(x, y, 1, 1).data ?? [])].slice(0, 3);
    },
    [cell % 40, Math.floor(cell / 40)],
  );
}

test("demo 1’s map as ROS files is the run’s map cell for cell, and lies on the mat again", {
  tag: "@once",
}, async ({ app, page }) => {
  await app.openLab("world=post-and-shelf");
  await app.showEndsAtOnce();
  const lab = page.locator("bugbot-lab");
  await app.more("Download as ROS map");
  await expect(app.status).toContainText("There is no map to take away at this moment");

  const { layers } = await lab.evaluate((element: Lab) => element.run());
  const { name, content } = await app.saved("Download as ROS map, as at the end of the run");
  expect(name).toBe("post-and-shelf-seed-1.zip");
  expect([...unzip(content).keys()]).toEqual([
    "post-and-shelf-seed-1.yaml",
    "post-and-shelf-seed-1.pgm",
  ]);
  const drawn = cellsOf(layers);
  const read = readRosMap(content);
  expect(read).toMatchObject({ width: 40, height: 40, resolution: 0.05, origin: [0, 0, 0] });
  expect(read.nav2).toEqual(drawn);
  expect(read.ros1).toEqual(drawn);
  const unknown = drawn.filter((cell) => cell === -1).length;
  expect(unknown).toBeGreaterThan(100);
  await expect(app.status).toContainText("as it is at the end of the run");
  await expect(app.status).toContainText(`${unknown} unknown`);

  await lab.evaluate((element: Lab) => element.seek(3));
  const atThree = await app.saved("Download as ROS map, as at 3.0 s");
  expect(atThree.name).toBe("post-and-shelf-seed-1-at-3.0-s.zip");
  await expect(app.status).toContainText("has the map as it is at 3.0 s");
  const early = readRosMap(atThree.content);
  expect(early.nav2.filter((cell) => cell === -1).length).toBeGreaterThan(unknown);

  // On a mat without a run, so that all that is there is the file.
  await app.world.selectOption("empty");
  const [free, wall, bare] = [0, 100, -1].map((value) => drawn.indexOf(value)) as [
    number,
    number,
    number,
  ];
  const mat = await colourAt(app.view, free);
  await app.openFile("Open a ROS map", "living-room.zip", content);
  await expect(app.status).toContainText("post-and-shelf-seed-1.yaml lies on the mat now");
  expect(await colourAt(app.view, free)).toEqual([158, 202, 225]);
  expect(await colourAt(app.view, wall)).toEqual([0, 0, 0]);
  expect(await colourAt(app.view, bare)).toEqual(mat);
  const legend = page.getByRole("group", { name: "Shown on the mat" });
  // It takes a row, on a phone two, and the way to be rid of it is in sight.
  const remove = legend.getByRole("button", { name: /Remove map/ });
  const [around, inside] = await Promise.all([legend.boundingBox(), remove.boundingBox()]);
  expect(inside?.x).toBeGreaterThanOrEqual(around?.x ?? Number.NaN);
  expect((inside?.x ?? 0) + (inside?.width ?? 0)).toBeLessThanOrEqual(
    (around?.x ?? 0) + (around?.width ?? Number.NaN),
  );
  expect(around?.height).toBeLessThan(150);
  await legend.getByText("40 × 40 cells of 5 cm").click();
  await expect(legend).toContainText("Read as trinary: occupied from 65 %, free to 19.6 %.");
  await legend.getByRole("checkbox", { name: /map post-and-shelf/ }).uncheck();
  expect(await colourAt(app.view, wall)).toEqual(mat);

  // What is wrong with a file is told, and leaves what is there.
  const files = unzip(content);
  const yaml = files.get("post-and-shelf-seed-1.yaml")?.toString() ?? "";
  const open = async (chosen: Record<string, string | Buffer>): Promise<void> => {
    const choosing = page.waitForEvent("filechooser");
    await app.more("Open a ROS map");
    await (await choosing).setFiles(
      Object.entries(chosen).map(([title, text]) => ({
        ...{ name: title, mimeType: "application/octet-stream", buffer: Buffer.from(text) },
      })),
    );
  };
  await open({ "room.yaml": yaml });
  await expect(app.status).toContainText(
    "room.yaml names the image post-and-shelf-seed-1.pgm, which was not chosen with it",
  );
  await open({
    "room.yaml": yaml.replace("resolution: 0.05", "resolution: small"),
    "post-and-shelf-seed-1.pgm": "P5",
  });
  await expect(app.status).toContainText(
    "room.yaml: line 3 of the map's YAML file: resolution should be a number",
  );
  await open({ "room.yaml": yaml, "post-and-shelf-seed-1.pgm": "P5\n40 40\n255\nshort" });
  await expect(app.status).toContainText("post-and-shelf-seed-1.pgm: ");

  await remove.click();
  await expect(legend).not.toContainText("40 × 40");

  // The two files dropped on the lab together.
  const dropped = await page.evaluateHandle(
    ([text, pixels]) => {
      const data = new DataTransfer();
      data.items.add(new File([text ?? ""], "room.yaml"));
      const bytes = Uint8Array.from(atob(pixels ?? ""), (letter) => letter.charCodeAt(0));
      data.items.add(new File([bytes], "post-and-shelf-seed-1.pgm"));
      return data;
    },
    [yaml, files.get("post-and-shelf-seed-1.pgm")?.toString("base64") ?? ""],
  );
  await app.view.dispatchEvent("drop", { dataTransfer: dropped });
  await expect(app.status).toContainText("room.yaml lies on the mat now");
});
