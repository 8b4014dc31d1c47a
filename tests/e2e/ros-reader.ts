/**
 * An independent reader of ROS map files: the rules of map servers restated from their documents,
 * with nothing of ours. A binary PGM and its YAML file, in an archive.
 *
 *   pixel x, 0 to 255; p = (255 - x) / 255, or x / 255 if negated
 *   p > occupied_thresh: 100; p < free_thresh: 0; else -1 (ROS 1 and nav2 until 2025)
 *   p >= occupied_thresh: 100; p <= free_thresh: 0; else -1 (nav2 since 2025)
 *   the image's first row is the top of the map; data goes row after row from the bottom
 */
import { inflateRawSync } from "node:zlib";

export interface ReadMap {
  width: number;
  height: number;
  resolution: number;
  origin: number[];
  /** As nav2 reads it, and as map_server of ROS 1 does. */
  nav2: number[];
  ros1: number[];
}

/** The files of a zip archive, by its local headers. */
export function unzip(archive: Buffer): Map<string, Buffer> {
  const files = new Map<string, Buffer>();
  for (let at = 0; archive.readUInt32LE(at) === 0x04034b50; ) {
    const method = archive.readUInt16LE(at + 8);
    const packed = archive.readUInt32LE(at + 18);
    const name = archive.readUInt16LE(at + 26);
    const from = at + 30 + name + archive.readUInt16LE(at + 28);
    const data = archive.subarray(from, from + packed);
    const title = archive.toString("utf8", at + 30, at + 30 + name);
    files.set(title, method === 8 ? inflateRawSync(data) : data);
    at = from + packed;
  }
  return files;
}

export function readRosMap(archive: Buffer): ReadMap {
  const files = unzip(archive);
  const yaml = [...files].find(([name]) => name.endsWith(".yaml"))?.[1].toString() ?? "";
  const said = new Map(yaml.split("\n").map((line) => line.split(/:\s*/, 2) as [string, string]));
  const list = (text = "") => text.replaceAll(/[[\]]/g, "").split(",").map(Number);
  const image = files.get(said.get("image") ?? "");
  if (!image) throw new Error(`no image ${said.get("image")} in ${[...files.keys()]}`);
  const header = /^P5\s+(?:#.*\s)*(\d+)\s+(\d+)\s+255\s/.exec(image.toString("latin1"));
  if (!header) throw new Error("the image is no binary PGM");
  const [width, height] = [Number(header[1]), Number(header[2])];
  const negate = said.get("negate") === "1";
  const occupied = Number(said.get("occupied_thresh"));
  const free = Number(said.get("free_thresh"));
  const shares = Array.from({ length: width * height }, (_, i) => {
    const row = height - 1 - Math.floor(i / width);
    const x = image[header[0].length + row * width + (i % width)] ?? Number.NaN;
    return negate ? x / 255 : (255 - x) / 255;
  });
  return {
    width,
    height,
    resolution: Number(said.get("resolution")),
    origin: list(said.get("origin")),
    nav2: shares.map((p) => (p >= occupied ? 100 : p <= free ? 0 : -1)),
    ros1: shares.map((p) => (p > occupied ? 100 : p < free ? 0 : -1)),
  };
}
