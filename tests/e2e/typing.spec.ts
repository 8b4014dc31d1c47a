/** A keyboard that types what is typed. `npm run typing` types every solution. */
import { parting, pieces, typePiece } from "../typing/typist.mjs";
import { expect, test } from "./fixtures.ts";

/** Slow enough for the completion list to come up between two keys [ms]. */
const SLOW_MS = 120;
const FAST_MS = 30;

const TYPED = [
  ["names that begin longer names", "CELL = 5\nCELL_CM = 7\nx = CELL\ny = CELL"],
  ["words that begin longer words", "while True:\n    break\nprint(1)\nimport math\nx = mat"],
  ["a docstring", 'def f():\n    """Doc."""\n    return 1'],
  [
    "a docstring over lines",
    "def f():\n    '''One.\n\n    Two \"x\" it's.\n    '''\n    return ''",
  ],
  [
    "texts and brackets",
    "a = [\"x\", 'y', f\"{1 + (2)}\", {'k': (1, [2])}]\nprint(a[0], '')  # it's",
  ],
  [
    "brackets over lines",
    "a = [\n    (1, 2),\n    (3, 4),\n]\nb = sum(\n    x\n    for x in (1, 2)\n)",
  ],
  [
    "branches",
    "if a:\n    if b:\n        c\n    else:\n        d\nelif e:\n    try:\n        f\n    except E:\n        g\nelse:\n    h",
  ],
] as const;

for (const { which, tag, texts } of [
  { which: "every other text", tag: ["@once"], texts: TYPED.filter((_text, at) => at % 2 === 1) },
  { which: "all texts", tag: ["@long"], texts: TYPED },
]) {
  test(`typed slowly, with the completion list at work: ${which}`, { tag }, async ({
    app,
    page,
  }) => {
    test.slow();
    await app.openLab("world=empty");
    for (const [name, typed] of texts) {
      await test.step(name, async () => {
        const there = await typePiece(page, { name, before: "", typed, after: "" }, SLOW_MS);
        expect.soft(there, name).toBe(typed);
      });
    }
  });
}

test("parts of solutions, typed", { tag: "@once" }, async ({ app, page }) => {
  test.setTimeout(120_000);
  await app.openLab("world=empty");
  const sample = pieces().filter((_piece, index) => index % 8 === 3);
  let keys = 0;
  for (const piece of sample) {
    if (keys + piece.typed.length > 500) continue;
    keys += piece.typed.length;
    const there = await typePiece(page, piece, FAST_MS);
    expect(parting(piece.before + piece.typed + piece.after, there), piece.name).toBeNull();
  }
  expect(keys).toBeGreaterThan(250);
});

test("Tab accepts a word of the list, Enter one that was chosen, and Enter alone is a new line", {
  tag: "@once",
}, async ({ app, page }) => {
  const { keyboard } = page;
  const option = page.getByRole("option", { name: /odometry/ });
  await app.openLab("world=empty");
  await app.write("from bugbot import *\n");
  await keyboard.press("ControlOrMeta+End");

  await keyboard.type("odom");
  await expect(option).toBeVisible();
  await keyboard.press("Tab");
  await keyboard.type("()");
  await keyboard.press("Enter");

  await keyboard.type("odom");
  await expect(option).toBeVisible();
  await keyboard.press("ArrowDown");
  await keyboard.press("Enter");
  await keyboard.press("Enter");

  await keyboard.type("odom");
  await expect(option).toBeVisible();
  await keyboard.press("Enter");
  await expect(option).toBeHidden();
  await keyboard.type("odometry");
  await expect(option).toBeHidden();
  await keyboard.press("Home");
  await keyboard.press("Tab");
  expect(await app.text()).toBe("from bugbot import *\nodometry()\nodometry\nodom\n    odometry");
});
