import { inflateRawSync } from "node:zlib";
import { expect, test } from "@playwright/test";
import { fillCalls, partsOf } from "../../site/build/calls-page.mjs";

const DOC = `Sound a tone.

freq: pitch in Hz
ms: how long

It goes on
while drive() does.

>>> for _ in range(2):
...     beep(440)  # doctest: +SKIP`;

test("a docstring comes apart into words, arguments and an example", () => {
  expect(partsOf(DOC)).toEqual([
    { kind: "text", text: "Sound a tone." },
    {
      kind: "arguments",
      list: [
        { name: "freq", meaning: "pitch in Hz" },
        { name: "ms", meaning: "how long" },
      ],
    },
    { kind: "text", text: "It goes on while drive() does." },
    { kind: "example", program: "for _ in range(2):\n    beep(440)\n" },
  ]);
});

test("a call has its words, and its example a link that carries the whole program", () => {
  const api = [{ name: "beep", signature: "beep(freq, ms=200)", summary: "", doc: DOC }];
  const groups = [{ title: "Showing", names: ["beep"] }];
  const html = fillCalls("<!-- contents --><!-- calls -->", { api, groups });
  expect(html).toContain('<a href="#beep"><code>beep(freq, ms=200)</code></a>');
  expect(html).toContain("while <code>drive()</code> does");
  const code = /#code=([\w-]+)/.exec(html)?.[1] ?? "";
  const program = inflateRawSync(Buffer.from(code, "base64url")).toString();
  expect(program).toBe("from bugbot import *\n\nfor _ in range(2):\n    beep(440)\n");
});

test("a group that names no call is our fault, and said", () => {
  const groups = [{ title: "Showing", names: ["hoot"] }];
  expect(() => fillCalls("", { api: [], groups })).toThrow('"Showing" names hoot');
});
