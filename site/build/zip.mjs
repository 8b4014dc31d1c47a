/** Writes a ZIP archive, as every system can unpack without help. Imports nothing of ours. */
import { crc32, deflateRawSync } from "node:zlib";

/** Where a time is wanted and none means anything: the earliest that the format can say. */
const DATE = (1 << 5) | 1;
/** Names are UTF-8. */
const FLAGS = 0x0800;
const VERSION = 20;
const DEFLATED = 8;
const STORED = 0;

/**
 * The archive of these files, in their order. The same files give the same bytes.
 * Throws a RangeError for a path that would lead out of the folder it is unpacked in.
 * @param {readonly { path: string, data: Uint8Array }[]} files with forward slashes in their paths
 * @returns {Buffer}
 */
export function zip(files) {
  /** @type {Buffer[]} */
  const parts = [];
  /** @type {Buffer[]} */
  const directory = [];
  let offset = 0;
  for (const { path, data } of files) {
    if (path.startsWith("/") || path.split("/").includes("..")) {
      throw new RangeError(`zip: "${path}" would be unpacked outside its folder`);
    }
    const name = Buffer.from(path, "utf8");
    const deflated = deflateRawSync(data, { level: 9 });
    // What is compressed already is kept as it is.
    const [method, body] =
      deflated.length < data.length ? [DEFLATED, deflated] : [STORED, Buffer.from(data)];
    const common = commonHeader(method, crc32(data), body.length, data.length, name.length);
    const local = [uint32(0x04034b50), uint16(VERSION), common, uint16(0), name, body];
    directory.push(
      ...[uint32(0x02014b50), uint16(VERSION), uint16(VERSION), common, uint16(0)],
      // No comment, disk 0, no attributes; where the file begins.
      ...[uint16(0), uint16(0), uint16(0), uint32(0), uint32(offset), name],
    );
    parts.push(...local);
    offset += local.reduce((sum, { length }) => sum + length, 0);
  }
  const list = Buffer.concat(directory);
  const count = uint16(files.length);
  return Buffer.concat([
    ...parts,
    list,
    ...[uint32(0x06054b50), uint16(0), uint16(0), count, count],
    ...[uint32(list.length), uint32(offset), uint16(0)],
  ]);
}

/**
 * What a file's own header and its line in the directory have in common.
 * @param {number} method
 * @param {number} check
 * @param {number} packed size in the archive
 * @param {number} size
 * @param {number} nameLength
 */
function commonHeader(method, check, packed, size, nameLength) {
  return Buffer.concat([
    ...[uint16(FLAGS), uint16(method), uint16(0), uint16(DATE)],
    ...[uint32(check), uint32(packed), uint32(size), uint16(nameLength)],
  ]);
}

/** @param {number} value */
function uint16(value) {
  const bytes = Buffer.alloc(2);
  bytes.writeUInt16LE(value);
  return bytes;
}

/** @param {number} value */
function uint32(value) {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32LE(value);
  return bytes;
}
