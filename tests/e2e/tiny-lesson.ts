/**
 * A lesson of two small tasks, put into a page of the built site while a story is told: so the
 * stories of tasks depend on no real lesson's words.
 */
import type { Page } from "@playwright/test";

const ROOM = {
  name: "a-pillar",
  title: "A pillar",
  description: "A mat that only checks use.",
  obstacles: [{ x: 80, y: 120, width: 40, height: 10, name: "pillar" }],
  start: { x: 100, y: 40, heading: 0 },
};

export const CELL_OF = {
  starter: `# Which cell holds the point (x, y)? A cell is 5 cm wide.

def cell_of(x, y):
    return (0, 0)
`,
  solution: `# Which cell holds the point (x, y)? A cell is 5 cm wide.

def cell_of(x, y):
    column = int(x // 5)
    row = int(y // 5)
    return (column, row)
`,
  swapped: `def cell_of(x, y):
    return (int(y // 5), int(x // 5))
`,
  endless: `def cell_of(x, y):
    while True:
        pass
`,
  check: `from grader import check, function

cell_of = function(
    "cell_of(x, y)",
    lambda x, y: (int(x // 5), int(y // 5)),
    mistakes=[
        ("row and column look swapped", lambda x, y: (int(y // 5), int(x // 5)), 1),
    ],
    cell_cm=5,
)


@check("The corner of the mat")
def corner(task):
    task.call(cell_of, 0, 0, gives=(0, 0))


@check("A point in a cell", hint=0)
def inside(task):
    task.call(cell_of, 12.5, 7.0, gives=(2, 1))


@check("Points all over the mat")
def all_over(task):
    for _ in range(5):
        task.call(cell_of, task.random.uniform(0, 200), task.random.uniform(0, 200))
`,
};

export const DRIVE = {
  starter: `from bugbot import *

forward(50, 20)
`,
  solution: `from bugbot import *

while distance() > 30:
    drive(50, 0, 0)
    wait(0.1)
stop()
`,
  check: `from grader import check


@check("It stops before what stands in its way")
def stops(task):
    run = task.run("a-pillar", seed=7, seconds=60)
    last = run.path[-1]
    task.expect(
        80 <= last[2] <= 100,
        expected="a stop 20 to 40 cm before the pillar",
        got=f"a stop {120 - last[2]:.0f} cm before it",
        run=run,
        cells=[(20, 24)],
        cell_cm=5,
    )
`,
};

type Texts = Partial<typeof CELL_OF>;

/** The data of the page; `changed` replaces texts of the first task. */
function dataOf(changed: Texts): string {
  const cellOf = { title: "The cell of a point", world: "empty", seed: 1, stretch: false };
  const stop = { title: "Stop in time", world: "wall-ahead", seed: 1, stretch: true };
  const data = {
    format: 1,
    lesson: "tiny",
    code: "U0",
    title: "A tiny lesson",
    worlds: [ROOM],
    programs: {},
    tasks: {
      "cell-of": { ...CELL_OF, ...changed, ...cellOf },
      "stop-in-time": { ...DRIVE, ...stop },
    },
  };
  return JSON.stringify(data).replaceAll("<", "\\u003c");
}

const task = (name: string, title: string, statement: string): string => `
  <bugbot-task id="task-${name}" name="${name}">
    <h3>${title}</h3>
    <div class="task-statement"><p>${statement}</p></div>
    <div class="task-plain"><pre>the starter</pre></div>
    <details class="task-hint"><summary>Hint 1</summary><p>A cell is 5 cm wide.</p></details>
    <details class="task-hint"><summary>Hint 2</summary><p>The column goes by <code>x</code>.</p></details>
    <details class="task-hint"><summary>Hint 3</summary><p>Use <code>//</code>.</p></details>
  </bugbot-task>`;

const mainOf = (data: string): string => `<main id="main" tabindex="-1">
  <h1>A tiny lesson</h1>
  <h2>Tasks</h2>
  ${task("cell-of", "The cell of a point", "Write <code>cell_of(x, y)</code>, which returns the column and the row of the cell that holds the point. Cells are 5 cm wide and counted from 0, from the lower left corner of the mat.")}
  ${task("stop-in-time", "Stop in time", "Drive up the mat and stop 20 to 40 cm before whatever is in the way.")}
  <progress-tools></progress-tools>
  <script type="application/json" id="lesson-data">${data}</script>
</main>`;

/** Opens the lesson: the lab's page, with the lesson's content in place of the lab. */
export async function openTinyLesson(page: Page, changed: Texts = {}): Promise<void> {
  const main = mainOf(dataOf(changed));
  const lab = await page.request.get("lab/");
  const html = (await lab.text()).replace(/<main[\s\S]*<\/main>/, () => main);
  await page.route("**/tiny/", (route) => route.fulfill({ contentType: "text/html", body: html }));
  await page.goto("tiny/");
}
