/** Which of the robot's calls a place in a program is in, and at which of its parameters. */
import { pythonLanguage } from "@codemirror/lang-python";
import { expect, test } from "@playwright/test";
import { type Call, callAround, parametersOf } from "../../site/src/editor/calls.ts";

const BEEP: Call = {
  name: "beep",
  signature: "beep(freq, ms=200)",
  summary: "Make a sound.",
  doc: "Make a sound.\n\nfreq: pitch in Hz\nms: how long, in ms",
};
const DRAW: Call = {
  name: "draw",
  signature: "draw(name, at=(0, 0), mark=',', *more)",
  summary: "Draw.",
  doc: "Draw.",
};
const CALLS = new Map([BEEP, DRAW].map((call) => [call.name, call]));

/** Call and parameter at the place marked by | in a program: "beep freq", "beep -", or null. */
function at(marked: string): string | null {
  const place = marked.indexOf("|");
  const text = marked.replace("|", "");
  const found = callAround(pythonLanguage.parser.parse(text), text, place, CALLS);
  if (!found) return null;
  const parameter = parametersOf(found.call)[found.parameter ?? -1];
  return `${found.call.name} ${parameter?.name ?? "-"}`;
}

test("parameters come from the signature and the docstring; commas in a default part none", () => {
  expect(parametersOf(BEEP)).toEqual([
    { name: "freq", text: "freq", meaning: "pitch in Hz" },
    { name: "ms", text: "ms=200", meaning: "how long, in ms" },
  ]);
  expect(parametersOf(DRAW).map(({ text }) => text)).toEqual(["name", "at=(0, 0)", "mark=','"]);
});

const PLACES: [program: string, found: string | null][] = [
  ["beep(|)", "beep freq"],
  ["beep(|", "beep freq"],
  ["beep(440|", "beep freq"],
  ["beep(440,|", "beep ms"],
  ["beep(440, |)", "beep ms"],
  ["beep(440|, 100)", "beep freq"],
  ["beep(440, 100, |)", "beep -"],
  ["beep(ms=|)", "beep ms"],
  ["beep(ms=100, freq=4|4)", "beep freq"],
  ["beep(\n    440,\n    |\n)", "beep ms"],
  ["beep(max(1, |2))", null],
  ["max(beep(1, |2), 3)", "beep ms"],
  ["beep([1, 2, |3])", "beep freq"],
  ["beep|(440)", null],
  ["beep(440)|", null],
  ["x = beep(1)\ny = |2\n", null],
  ["draw('a, b|')", "draw name"],
  ["robot = connect()\nrobot.beep(|)", "beep freq"],
  ["horn.beep(|)", null],
  ["def beep(freq):\n    pass\n\nbeep(|)", null],
];

for (const [program, found] of PLACES) {
  test(`in ${JSON.stringify(program)}: ${found ?? "no call of the robot's"}`, () => {
    expect(at(program)).toBe(found);
  });
}
