/**
 * A program in a link: `/lab/?world=NAME&seed=N#code=TEXT`, where TEXT is the program in UTF-8,
 * deflated (deflate-raw) and in base64url. What stands behind # is never sent to a server.
 *
 * A link with `#mat=` carries a mat in the same way (`mats/mat-file.ts`).
 *
 * A link may come from anyone, so unpacking is bounded, and nothing here opens or runs anything.
 * May import `ui` and `address`.
 */
import { shareWords } from "../ui/file-words.ts";
import { type Place, writeAddress } from "./address.ts";
import { decodeText, MOST_PROGRAM_BYTES } from "./text-file.ts";

/** Longer links are cut by some mail and chat programs [characters]. */
export const LONG_LINK = 8000;
/**
 * Unpacking is fed so much at a time, and what comes out is counted in between: deflate packs up
 * to a thousand to one, so a piece can't become more than about a megabyte [bytes].
 */
const PIECE_BYTES = 1024;

/** A link that holds no program that could be opened; the message is for the reader. */
export class ShareError extends Error {
  override readonly name = "ShareError";
}

export async function linkTo(lab: string, place: Place, program: string): Promise<string> {
  return `${lab}${writeAddress(place)}#code=${await pack(program)}`;
}

/** The packed program or mat in the part of an address behind #, or null where there is none. */
export function packedIn(hash: string, what: "code" | "mat" = "code"): string | null {
  return new URLSearchParams(hash.slice(1)).get(what);
}

export async function pack(program: string): Promise<string> {
  const packed = new Blob([program]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  let binary = "";
  // As arguments of one call a large program would overflow the stack.
  for (let i = 0; i < bytes.length; i += 0x8000) {
    binary += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  }
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/**
 * Throws ShareError, in words for what the link should hold, if the text is not what `pack` makes,
 * or unpacks to more bytes than that.
 */
export async function unpack(
  code: string,
  mostBytes = MOST_PROGRAM_BYTES,
  words: { broken: string; tooLarge: string } = shareWords,
): Promise<string> {
  const bytes = fromBase64Url(code);
  if (bytes === null) throw new ShareError(words.broken);
  const unpacked = inPieces(bytes).pipeThrough(new DecompressionStream("deflate-raw"));
  const read = await readAtMost(unpacked, mostBytes);
  if (read === "too much") throw new ShareError(words.tooLarge);
  const text = read && decodeText(read);
  if (text === null) throw new ShareError(words.broken);
  return text;
}

function fromBase64Url(code: string): Uint8Array<ArrayBuffer> | null {
  const plain = code.replaceAll(/\s/g, "").replaceAll("-", "+").replaceAll("_", "/");
  try {
    return Uint8Array.from(atob(plain), (sign) => sign.charCodeAt(0));
  } catch {
    return null;
  }
}

function inPieces(bytes: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0;
  return new ReadableStream(
    {
      pull(controller) {
        if (at < bytes.length) controller.enqueue(bytes.subarray(at, at + PIECE_BYTES));
        else controller.close();
        at += PIECE_BYTES;
      },
    },
    { highWaterMark: 0 },
  );
}

/** Null if the stream breaks off or holds no packed text. */
async function readAtMost(
  stream: ReadableStream<Uint8Array>,
  most: number,
): Promise<Uint8Array | "too much" | null> {
  const reader = stream.getReader();
  const blocks: Uint8Array[] = [];
  let length = 0;
  try {
    for (let read = await reader.read(); !read.done; read = await reader.read()) {
      length += read.value.length;
      if (length > most) {
        await reader.cancel();
        return "too much";
      }
      blocks.push(read.value);
    }
  } catch {
    return null;
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const block of blocks) {
    all.set(block, at);
    at += block.length;
  }
  return all;
}
