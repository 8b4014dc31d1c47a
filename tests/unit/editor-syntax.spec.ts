/** What the editor says of text that is not yet Python: the place and the reason, or nothing. */
import { pythonLanguage } from "@codemirror/lang-python";
import { expect, test } from "@playwright/test";
import { firstProblem } from "../../site/src/editor/syntax.ts";

function problemOf(text: string): { line: number; message: string } | null {
  const problem = firstProblem(pythonLanguage.parser.parse(text), text);
  return (
    problem && { line: text.slice(0, problem.from).split("\n").length, message: problem.message }
  );
}

const WRONG: [what: string, text: string, line: number, says: string][] = [
  ["a bracket never closed", "x = 1\nprint('a'\ny = 2\n", 2, "( is never closed"],
  ["a list never closed", "x = [1, 2\ny = 3\n", 1, "[ is never closed"],
  ["a bracket too many", "x = (1 + 2))\n", 1, ") closes nothing"],
  ["brackets that do not match", "x = (1, 2]\n", 1, "] does not match the ("],
  ["text that never ends", "x = 'abc\ny = 2\n", 1, "never ends with '"],
  ["long text that never ends", 'x = """abc\n\n', 1, 'never ends with """'],
  ["a missing colon after for", "for i in range(3)\n    print(i)\n", 1, "for ends with a colon"],
  ["a missing colon after if", "if x > 1\n    y = 2\n", 1, "if ends with a colon"],
  [
    "a missing colon after while",
    "while True  # for ever\n    y = 2\n",
    1,
    "while ends with a colon",
  ],
  ["a missing colon after def", "def f(a)\n    return 1\n", 1, "def ends with a colon"],
  ["a missing colon after else", "if a:\n    b\nelse\n    c\n", 3, "else ends with a colon"],
  ["one equals sign in a question", "if x = 3:\n    pass\n", 1, "write == with two signs"],
  ["a block without lines", "if x:\ny = 1\n", 1, "indented by four spaces"],
  ["an else of nothing", "x = 1\nelse:\n    pass\n", 2, "This else belongs to nothing"],
  ["print of Python 2", "x = 1\nprint 'x'\n", 2, "print needs brackets"],
  ["half a sum", "x = 1 +\ny = 2\n", 1, "cannot read this line"],
];

for (const [what, text, line, says] of WRONG) {
  test(what, () => {
    const problem = problemOf(text);
    expect(problem?.message).toContain(says);
    expect(problem?.line).toBe(line);
  });
}

const RIGHT = [
  "",
  "# only a comment with a ( in it\n",
  "x = 'it is (fine'  # and ) here\n",
  "print(f'{x:.2f} {y!r} {z}')\n",
  "x = r'\\d' + b'a'.decode() + \"it's\"\n",
  'x = """a\n(b\n"""\n',
  "x = {\n    'a': [1, 2],  # ]\n    'b': (3,),\n}\n",
  "match x:\n    case 1:\n        pass\n    case _:\n        pass\n",
  "async def f():\n    async with a as b:\n        await c\n",
  "if (n := 10) > 5: print(n)\n",
  "try:\n    pass\nexcept (A, B) as error:\n    raise\nelse:\n    pass\nfinally:\n    pass\n",
  "def f(a, /, b: int = 3, *args, c, **kwargs) -> dict[str, int]:\n    return lambda x: x\n",
  "class A(B, metaclass=C):\n    x: int = 1\n\n    @property\n    def y(self): ...\n",
  "while True:\n    if done: break\n",
  "x = [i for i in range(3) if i % 2 == 0]\ny = x[1:-1:2]\nz = a if b else c\n",
];

for (const text of RIGHT) {
  test(`nothing wrong with ${JSON.stringify(text.slice(0, 40))}`, () => {
    expect(problemOf(text)).toBeNull();
  });
}
