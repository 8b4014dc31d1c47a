/**
 * A lesson's folder becomes a page, or a list of what is wrong with it: small courses in a folder of
 * their own, their programs run in the site's own Python.
 */
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { expect, test } from "@playwright/test";
import { Course, type World } from "../../site/build/lessons/course.mjs";
import { LessonFaults } from "../../site/build/lessons/faults.mjs";
import { Measurer } from "../../site/build/lessons/measure.mjs";
import { preparePython } from "../../site/build/python.mjs";

/** Counts the seconds, and says what it has come to. */
const COUNTING = `from bugbot import *

STEP = 1  # how much is added each second (0 to 10)

total = 0
for second in range(4):
    total += STEP
    plot("total", total)
    wait(1)
draw("dots", [(10, 10), (20, 20), (30, 30)])
print("in the end:", total / 8)
`;

const ABOUT = {
  format: 1,
  title: "Counting",
  summary: "A lesson for the tests.",
  goals: ["count"],
  programs: { counting: { world: "empty", title: "Counting seconds" } },
};

const folders: string[] = [];

let python: Awaited<ReturnType<typeof preparePython>>;

test.beforeAll(async () => {
  // Where nothing has been built yet, the interpreter's snapshot is made first.
  test.setTimeout(300_000);
  python = await preparePython();
});

test.afterAll(() => {
  for (const folder of folders) rmSync(folder, { recursive: true, force: true });
});

/** A course of one lesson, "counting"; files beside the usual ones, or in their place. */
function courseOf(prose: string, files: Record<string, string> = {}): Course {
  const folder = mkdtempSync(join(tmpdir(), "course-"));
  folders.push(folder);
  const all = {
    "course.json": JSON.stringify({ format: 1, lessons: ["counting"] }),
    "counting/lesson.json": JSON.stringify(ABOUT, null, 2),
    "counting/lesson.md": prose,
    "counting/programs/counting.py": COUNTING,
    ...files,
  };
  for (const [path, text] of Object.entries(all)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), text);
  }
  const worlds = python.course.worlds as World[];
  const live = { beam: "<p>a beam</p>" };
  return new Course({ folder, worlds, measurer: new Measurer(python), live, katex: null });
}

async function pageOf(prose: string, files?: Record<string, string>): Promise<string> {
  const html = await courseOf(prose, files).page("counting");
  return html ?? "";
}

/** What is wrong, as `file:line: fault`, the file without its folder. */
async function faultsOf(prose: string, files?: Record<string, string>): Promise<string[]> {
  const course = courseOf(prose, files);
  const error = await course.page("counting").catch((thrown: unknown) => thrown);
  if (!(error instanceof LessonFaults)) throw new Error("the lesson has no faults");
  return error.faults.map(({ file, line, fault }) => `${file.split("/").at(-1)}:${line}: ${fault}`);
}

/** The figures of a page: what is shown, and the number itself. */
function figuresIn(html: string): [shown: string, value: number][] {
  const found = html.matchAll(/<data value="([^"]*)"[^>]*>([^<]*)<\/data>/g);
  return [...found].map(([, value, shown]) => [shown ?? "", Number(value)]);
}

test("figures of every kind come from a run of the program", async () => {
  const html = await pageOf(`::program counting

{{ counting: total at 2.5 s }}, {{ counting: total at the end }}, {{ counting: highest total }},
{{ counting: lowest total }}, {{ counting: first time total reaches 3 }}, {{ counting: count of dots }},
{{ counting: seconds }}, {{ counting: x }}, {{ counting: number after "in the end:" }},
{{ counting: number after "in the end:" | 2 }}, {{ counting with STEP = -0.5: total at the end }},
{{ counting seeds 1 to 3: median of total at the end }}

| in a table | with digits |
| --- | --- |
| one | {{ counting: total at the end | 1 }} |
`);
  expect(figuresIn(html).map(([shown]) => shown)).toEqual([
    "3",
    "4",
    "4",
    "1",
    "2",
    "3",
    "4",
    "100",
    "0.5",
    "0.50",
    "−2",
    "4",
    "4.0",
  ]);
  expect(html).toContain('data-of="counting with STEP = -0.5: total at the end"');
  expect(html).toContain('title="Measured: counting with STEP = -0.5, seed 1: total at the end"');
});

test("a reference that can't be resolved is told with its line, what is wrong and what there is", async () => {
  const faults = await faultsOf(`Several at once.

{{ counting: totl at the end }} and
{{ conting: total at the end }}.

- {{ counting: total }}
- {{ counting with STP = 2: total at the end }}
- {{ counting: first time total reaches 9 }}
- {{ try counting: STEP = 99 }}
`);
  expect(faults).toEqual([
    'lesson.md:3: {{ counting: totl at the end }}: the run plots no line called "totl"; there is: "total"',
    'lesson.md:4: there is no program "conting"',
    'lesson.md:6: "total" is no quantity',
    expect.stringMatching(/^lesson\.md:7: .*counting\.py has no line STP = NUMBER$/),
    'lesson.md:8: {{ counting: first time total reaches 9 }}: "total" never reaches 9: it goes from 1 to 4',
    'lesson.md:9: the program "counting" has no lab on this page',
    expect.stringMatching(/^lesson\.md:9: STEP = 99 is outside 0 to 10/),
  ]);
});

test("a check that is so shows nothing, and one that is not fails the build", async () => {
  const right = await pageOf(`::program counting

{{ check counting with STEP = 2: total at the end > counting: total at the end }}

{{ check counting: total at the end within 5 % of 4.1 }} Words.`);
  expect(right).not.toContain("check");
  expect(right).toContain("<p> Words.</p>");

  expect(
    await faultsOf("::program counting\n\n{{ check counting: total at the end > 4 }}"),
  ).toEqual([
    'lesson.md:3: the check "counting: total at the end > 4" is not so: 4.0000 against 4.0000',
  ]);
});

test("a run that does not finish gives no figures", async () => {
  const [fault] = await faultsOf("::program counting\n\n{{ counting: seconds }}", {
    "counting/programs/counting.py": "print(1 / 0)\n",
  });
  expect(fault).toMatch(
    /^lesson\.md:3: the run of counting, seed 1 did not finish: .*error on line 1/,
  );
});

test("lesson.json is held against its schema, with lines", async () => {
  const wrong = { ...ABOUT, minutes: "long", goal: [], programs: {} };
  expect(
    await faultsOf("Words.", { "counting/lesson.json": JSON.stringify(wrong, null, 2) }),
  ).toEqual([
    "lesson.json:9: minutes is a text, not a whole number",
    "lesson.json:10: goal is not known here",
  ]);
  expect(await faultsOf("Words.", { "counting/lesson.json": "{\n  oops\n}" })).toEqual([
    "lesson.json:2: this is not JSON (InvalidSymbol)",
  ]);
});

test("programs, tasks, pictures, links, formulas and headings are looked after", async () => {
  const faults = await faultsOf(`# Title

::programm counting

::picture nothing

[there](../nowhere/) and $\\frac{1}$ and {{ open

## Same

## Same
`);
  expect(faults.map((fault) => fault.replace(/:? KaTeX.*|can't be read.*/, ""))).toEqual([
    'lesson.json:9: the program "counting" is shown nowhere',
    "lesson.md:1: a heading of the first level",
    "lesson.md:3: there is no directive ::programm",
    'lesson.md:5: there is no picture "nothing"',
    "lesson.md:7: the formula \\frac{1} ",
    "lesson.md:7: {{ is never closed in this piece of text",
    "lesson.md:7: the link ../nowhere/ leads to no page of the site",
    'lesson.md:11: there is another heading "Same" on this page',
  ]);
});

test("a whole page can be read without scripts, and tells them what they need", async () => {
  const task = {
    name: "add-up",
    title: "Add up",
    statement: "Add *all* of it.",
    world: "empty",
    hints: ["one", "two", "three"],
  };
  const html = await pageOf(
    `## First

A formula $x^2$ and {{ try counting: STEP = 2 }}.

::program counting

::task add-up

::live beam Drag the beam.

::picture plain A square.

## Questions

### What is it?

It comes to {{ counting: total at the end }}.

### Why?

Because "so".
`,
    {
      "counting/lesson.json": JSON.stringify({ ...ABOUT, tasks: [task] }),
      "counting/add-up/starter.py": "# begin\n",
      "counting/add-up/solution.py": "# end </script>\n",
      "counting/add-up/check.py": "",
      "counting/pictures/plain.py":
        'def picture():\n    return "<svg viewBox=\'0 0 1 1\'><title id=\\"t\\">A</title><desc>b</desc></svg>"\n'.replace(
          /'0 0 1 1'/,
          '\\"0 0 1 1\\"',
        ),
    },
  );
  expect(html).toContain('<bugbot-lab id="lab-counting" program-of="counting"');
  expect(html).toMatch(/<span class="code-keyword">from<\/span> bugbot/);
  expect(html).toContain('data-constants="{&quot;STEP&quot;:2}"');
  expect(html).toContain("Add <em>all</em> of it.");
  expect(html.match(/<details class="task-hint">/g)).toHaveLength(3);
  expect(html).toContain("Figure 1.");
  expect(html).toContain('id="picture-plain-t"');
  expect(html).toContain("<p>a beam</p>");
  expect(html).toContain("<math xmlns=");
  expect(html).toContain("Because “so”.");
  const data = /id="lesson-data">(.*?)<\/script>/.exec(html)?.[1] ?? "";
  expect(JSON.parse(data).tasks["add-up"].solution).toBe("# end </script>\n");
  const faq = /application\/ld\+json">(.*?)<\/script>/.exec(html)?.[1] ?? "";
  const { mainEntity } = JSON.parse(faq);
  expect(mainEntity).toHaveLength(2);
  expect(mainEntity[0].name).toBe("What is it?");
  expect(mainEntity[0].acceptedAnswer.text).toBe("It comes to 4.");
});
