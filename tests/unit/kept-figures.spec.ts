/**
 * The numbers that are kept beside a lesson: used for just the runs and the simulator that they are of,
 * and otherwise measured anew. A measurer of the tests' own says what was run.
 */
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { Course, type World } from "../../site/build/lessons/course.mjs";
import { codeOf, hashOfSimulator } from "../../site/build/lessons/figure-inputs.mjs";
import { KeptFigures } from "../../site/build/lessons/kept-figures.mjs";
import type { Measurer } from "../../site/build/lessons/measure.mjs";
import type { Job } from "../../site/build/lessons/python-worker.mjs";

const ABOUT = {
  format: 1,
  title: "Counting",
  summary: "A lesson for the tests.",
  goals: ["count"],
  programs: { counting: { world: "empty", title: "Counting" } },
};
const PROSE = `::program counting

{{ counting: seconds }} {{ counting with STEP = 3: seconds }} {{ counting seeds 1 to 4: highest of seconds }}
`;
const PROGRAM = "STEP = 2\nprint(STEP)\n";

let folder: string;

test.beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), "kept-"));
  put("course.json", JSON.stringify({ format: 1, lessons: ["counting"] }));
  put("counting/lesson.json", JSON.stringify(ABOUT));
  put("counting/lesson.md", PROSE);
  put("counting/programs/counting.py", PROGRAM);
});

test.afterEach(() => rmSync(folder, { recursive: true, force: true }));

function put(path: string, text: string): void {
  mkdirSync(dirname(join(folder, path)), { recursive: true });
  writeFileSync(join(folder, path), text);
}

const FILE = "counting/figures.json";
const fileText = () => readFileSync(join(folder, FILE), "utf8");

interface Making {
  /** How many programs were run. */
  ran: number;
  values: number[];
  isCurrent: boolean;
  isContradicted: boolean;
}

/** Make the lesson's page; a run takes 10 s for each STEP and one for each seed, and `slower`. */
async function make({ keep = false, again = false, slower = 0 } = {}): Promise<Making> {
  let ran = 0;
  const answer = (job: Job) => {
    if (job.kind !== "run") throw new Error("no pictures here");
    ran += 1;
    const step = Number(/STEP = (\d+)/.exec(job.program)?.[1]);
    return {
      outcome: JSON.stringify({ status: "finished", seconds: 10 * step + job.seed + slower }),
    };
  };
  const measurer = { answers: async (jobs: readonly Job[]) => jobs.map(answer) };
  const world = { name: "empty", obstacles: [] } as unknown as World;
  const course = new Course({
    folder,
    worlds: [world],
    measurer: measurer as unknown as Measurer,
    live: {},
    katex: null,
    again: () => again,
  });
  await course.page("counting");
  const stale = course.staleOf(["counting"]);
  if (keep) for (const kept of stale) kept.write();
  return {
    ran,
    values: inOrder(course.valuesOf("counting")),
    isCurrent: stale.length === 0,
    isContradicted: stale.some((kept) => kept.isContradicted),
  };
}

/** The numbers in the order in which the prose quotes them. */
function inOrder(values: Map<string, number>): number[] {
  const prose = readFileSync(join(folder, "counting/lesson.md"), "utf8");
  const entries = [...values].sort(([a], [b]) => prose.indexOf(a) - prose.indexOf(b));
  return entries.map(([, value]) => value);
}

test("figures that are kept are not measured again, and come out the same", async () => {
  const first = await make({ keep: true });
  expect(first).toMatchObject({ ran: 6, values: [21, 31, 24], isCurrent: false });
  expect(await make()).toMatchObject({ ran: 0, values: [21, 31, 24], isCurrent: true });
});

test("what has changed is measured anew, and only that", async () => {
  await make({ keep: true });
  put("counting/lesson.md", PROSE.replace("STEP = 3", "STEP = 4"));
  expect(await make({ keep: true })).toMatchObject({ ran: 1, isCurrent: false });
  expect(fileText()).not.toContain("STEP = 3");
  put("counting/programs/counting.py", PROGRAM.replace("STEP = 2", "STEP = 5"));
  // With STEP = 4 in its place, it is the program that it was.
  expect(await make({ keep: true })).toMatchObject({ ran: 5, values: [51, 41, 54] });
  expect(await make()).toMatchObject({ ran: 0, isCurrent: true });
});

test("another world or another seed is another run", async () => {
  await make({ keep: true });
  const own = { ...ABOUT, programs: { counting: { ...ABOUT.programs.counting, seed: 7 } } };
  put("counting/lesson.json", JSON.stringify(own));
  // Only the figure with seeds of its own stays what it was.
  expect(await make({ keep: true })).toMatchObject({ ran: 2, values: [27, 37, 24] });
  own.programs.counting.world = "small";
  put("counting/lesson.json", JSON.stringify(own));
  put("counting/worlds/small.json", JSON.stringify({ name: "small", obstacles: [] }));
  expect((await make()).ran).toBe(6);
});

test("figures by another simulator are not used", async () => {
  await make({ keep: true });
  put(FILE, fileText().replace(/"simulator": "\w+"/, '"simulator": "0"'));
  expect(await make({ keep: true })).toMatchObject({ ran: 6, isCurrent: false });
  expect((await make()).ran).toBe(0);
});

test("a number changed by hand is seen when it is measured again", async () => {
  await make({ keep: true });
  put(FILE, fileText().replace('"value": 31', '"value": 32'));
  expect((await make()).ran).toBe(0);
  const again = await make({ again: true });
  expect(again).toMatchObject({ ran: 6, values: [21, 31, 24], isContradicted: true });
  expect(await make({ again: true, keep: true })).toMatchObject({ isCurrent: false });
  expect(await make({ again: true })).toMatchObject({ isCurrent: true, isContradicted: false });
});

test("what nothing asks for any more, and a damaged file, are written anew", async () => {
  await make({ keep: true });
  const right = fileText();
  for (const damaged of [`<<<<<<< here\n${right}`, "[]", "null", '{ "figures": 3 }', ""]) {
    put(FILE, damaged);
    expect(await make({ keep: true })).toMatchObject({ ran: 6, isCurrent: false });
    expect(fileText()).toBe(right);
  }
  put("counting/lesson.md", "::program counting\n");
  expect(await make({ keep: true })).toMatchObject({ ran: 0, isCurrent: false });
  expect(existsSync(join(folder, FILE))).toBe(false);
  expect((await make()).isCurrent).toBe(true);
});

test("what a program says of the machine's own speed is measured each time", async () => {
  put("counting/programs/counting.py", `from timeit import timeit\n${PROGRAM}`);
  await make({ keep: true });
  expect(existsSync(join(folder, FILE))).toBe(false);
  expect(await make({ slower: 1 })).toMatchObject({
    ran: 6,
    values: [22, 32, 25],
    isCurrent: true,
  });
});

test("a figure's line is one line, in order", () => {
  const kept = new KeptFigures(join(folder, "counting"), "f00d");
  kept.add("b: seconds", "2222", 1.5);
  kept.add('a: number after "x:"', "1111", -2);
  kept.write();
  expect(fileText().split("\n").slice(2, 6)).toEqual([
    '  "simulator": "f00d",',
    '  "figures": {',
    '    "a: number after \\"x:\\"": { "value": -2, "runs": "1111" },',
    '    "b: seconds": { "value": 1.5, "runs": "2222" }',
  ]);
});

test("better words in the simulator make nothing stale; other code does", () => {
  const bugbot = join(folder, "bugbot");
  cpSync(join(ROOT, "py/bugbot"), bugbot, { recursive: true });
  const before = hashOfSimulator(bugbot);
  const change = (path: string, to: (text: string) => string): string => {
    const text = readFileSync(join(bugbot, path), "utf8");
    expect(to(text)).not.toBe(text);
    writeFileSync(join(bugbot, path), to(text));
    const hash = hashOfSimulator(bugbot);
    writeFileSync(join(bugbot, path), text);
    return hash;
  };
  expect(change("sim/noise.py", (text) => text.replace('"""', '"""Read this. '))).toBe(before);
  expect(change("sim/noise.py", (text) => `${text}\n# The end.\n`)).toBe(before);
  expect(change("errors.py", (text) => `${text}\nWORDS = "better"\n`)).toBe(before);
  expect(change("sim/noise.py", (text) => text.replaceAll("\n", "\r\n"))).toBe(before);
  expect(change("sim/noise.py", (text) => text.replace("= 2.0", "= 2.1"))).not.toBe(before);
  expect(change("api.py", (text) => `${text}\nprint()\n`)).not.toBe(before);
  expect(hashOfSimulator(bugbot)).toBe(before);
});

test("the code of a file is all that does something", () => {
  const code = (...lines: string[]) => codeOf(lines.join("\n"));
  const plain = code("def f(a):", "    return a");
  expect(code('"""Why."""', "", "def f(a):  # how", "    'What.'", "", "    return  a")).toBe(
    plain,
  );
  expect(code("if a:", "    b()", "c()")).not.toBe(code("if a:", "    b()", "    c()"));
  expect(code('a = "b"')).not.toBe(code('a = "b "'));
  expect(code('a = f"b {c}"')).not.toBe(code('a = f"b{c}"'));
  expect(code('f"{a()}"')).not.toBe(code(""));
  expect(code("a = 1", '"about a"')).toBe(code("a = 1"));
  expect(code('a = """x', '# y"""')).not.toBe(code('a = """x', '# z"""'));
});
