/** Every kind of bad input ends with a clear message on the right line, and the next run works. */
import { expect, test } from "./fixtures.ts";

interface Case {
  what: string;
  program: string;
  line: number;
  says: RegExp;
}

const FAULTS: Case[] = [
  {
    what: "a syntax error",
    program: "from bugbot import *\nfor i in range(3)\n    wait(1)\n",
    line: 2,
    says: /:/,
  },
  {
    what: "a wrong type of argument",
    program: 'from bugbot import *\nwait(1)\nforward("fast")\n',
    line: 3,
    says: /forward.*fast/,
  },
  {
    what: "a negative wait",
    program: "from bugbot import *\nwait(-1)\n",
    line: 2,
    says: /wait.*-1/,
  },
  {
    what: "a wait that is not a number",
    program: 'from bugbot import *\nwait(float("nan"))\n',
    line: 2,
    says: /wait.*nan/i,
  },
  {
    what: "input()",
    program: 'name = input("Who are you? ")\n',
    line: 1,
    says: /input/,
  },
  {
    what: "importing what is not there",
    program: "import math\nimport nothing_like_this\n",
    line: 2,
    says: /nothing_like_this/,
  },
  {
    what: "calls without end",
    program: "def again(n):\n    return again(n + 1)\n\nagain(0)\n",
    line: 2,
    says: /call|recurs/i,
  },
];

test("faults and odd ends: the message names the line, and the program is kept", async ({
  app,
}) => {
  test.slow();
  await app.openLab("world=empty");
  await app.showEndsAtOnce();
  for (const { what, program, line, says } of FAULTS) {
    await test.step(what, async () => {
      await app.runToEnd(program);
      await expect(app.status).toHaveText(`An error on line ${line} ended the program.`);
      await expect(app.problem).toContainText(says);
      expect(await app.text()).toBe(program);
    });
  }
  await app.runToEnd('print("still working")');
  await expect(app.console).toContainText("still working");

  // What ends oddly, but not by a fault.
  await test.step("an empty program", async () => {
    await app.runToEnd("");
    await expect(app.status).toHaveText("Finished at 0.0 s.");
  });

  await test.step("sys.exit()", async () => {
    await app.runToEnd('import sys\nprint("before")\nsys.exit()\nprint("after")\n');
    await expect(app.status).toHaveText("Finished at 0.0 s.");
    await expect(app.console).toContainText("before");
    await expect(app.console).not.toContainText("after");
  });

  await test.step("printing without end", async () => {
    await app.runToEnd("while True:\n    print('again and again')\n");
    await expect(app.status).toHaveText(/no simulated time passes/);
    await expect(app.console).toContainText("again and again");
  });

  await test.step("driving without end", async () => {
    await app.runToEnd("from bugbot import *\nright(10)\nwhile True:\n    wait(1)\n");
    await expect(app.status).toHaveText(/600/);
  });

  await test.step("a program of a million characters", async () => {
    const program = `x = 0\n${"x = x + 1  # one more\n".repeat(45_000)}print("sum", x)\n`;
    await app.setProgram(program);
    await app.run.click();
    await app.ended();
    await expect(app.console).toContainText("sum 45000");
    expect(await app.text()).toBe(program);
  });
});
