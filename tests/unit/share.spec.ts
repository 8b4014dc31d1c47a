/** A program in a link: there and back, and whatever else may stand in one. */
import { expect, test } from "@playwright/test";
import { linkTo, pack, packedIn, ShareError, unpack } from "../../site/src/page/share.ts";
import { MOST_PROGRAM_BYTES } from "../../site/src/page/text-file.ts";

const PROGRAMS = {
  "a small one": 'from bugbot import *\nprint("hello")\n',
  "an empty one": "",
  "letters of every kind": 'print("Grüße, 世界, 🤖, e\u0301, \u202e")\n',
  "quotes and signs": "#?&=%+/\\'\"`\u0024{x}</script>\n\t\n",
  "one of a megabyte": "x = 0  # one\n".repeat(MOST_PROGRAM_BYTES / 13),
};

for (const [what, program] of Object.entries(PROGRAMS)) {
  test(`there and back: ${what}`, async () => {
    const link = await linkTo("https://a.school/b/lab/", { world: "empty", seed: 7 }, program);
    const { pathname, search, hash } = new URL(link);
    expect(pathname + search).toBe("/b/lab/?world=empty&seed=7");
    expect(hash).toMatch(/^#code=[\w-]+$/);
    expect(await unpack(packedIn(hash) ?? "")).toBe(program);
  });
}

test("a link that a mail program has broken into lines still opens", async () => {
  const packed = await pack("print(1)\n");
  expect(await unpack(`${packed.slice(0, 5)}\n ${packed.slice(5)}`)).toBe("print(1)\n");
});

test("an address without a program has none", () => {
  expect(packedIn("")).toBeNull();
  expect(packedIn("#main")).toBeNull();
});

const refusal = (code: string) =>
  unpack(code).then(
    () => "opened",
    (error) => (error instanceof ShareError ? error.message : `not a ShareError: ${error}`),
  );

test("a damaged link is refused in plain words", async () => {
  const packed = await pack(PROGRAMS["a small one"]);
  const noText = Buffer.from([0xff, 0xfe, 0x00]);
  const broken = ["", "!!!", "AAAA", packed.slice(0, -4), await packBytes(noText)];
  for (const code of broken) expect(await refusal(code), code).toContain("cannot be read");
});

test("a link that unpacks to more than a megabyte is refused", async () => {
  expect(await refusal(await pack("a".repeat(MOST_PROGRAM_BYTES)))).toBe("opened");
  expect(await refusal(await pack("a".repeat(MOST_PROGRAM_BYTES + 1)))).toContain("1 MB");
});

test("one that would unpack to 64 MB is given up at the first", async () => {
  const bomb = await packBytes(new Uint8Array(64_000_000));
  expect(bomb.length).toBeLessThan(100_000);
  const before = process.memoryUsage().arrayBuffers;
  expect(await refusal(bomb)).toContain("1 MB");
  expect(process.memoryUsage().arrayBuffers - before).toBeLessThan(30_000_000);
});

async function packBytes(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const packed = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  return Buffer.from(await new Response(packed).arrayBuffer()).toString("base64url");
}
