/**
 * Runs in the sandbox, in place of its performer: tries every way out in the locked-down interpreter,
 * without the fences that Python has while it marks, and says for each what it printed.
 * In: one line of JSON, a list of {"name", "program"}. Out: one line of JSON, name -> text, up to the
 * first that broke the interpreter.
 */
import { readFileSync, writeSync } from "node:fs";
import { startConfined } from "../../site/sandbox/confined.ts";

const RUN = `
def run(program):
    import contextlib, io
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        try:
            exec(compile(program, "program.py", "exec"), {"__name__": "__main__"})
        except BaseException as error:
            print(type(error).__name__, error)
    return said.getvalue()
`;

interface Scope {
  get(name: "run"): (program: string) => string;
}

interface Builtins {
  dict(): Scope;
  exec(program: string, scope: Scope): void;
}

const exit = process.exit.bind(process);
const { sealed } = await startConfined([]);
const builtins = sealed.module("builtins") as Builtins;
const scope = builtins.dict();
builtins.exec(RUN, scope);
const run = scope.get("run");
const ways = JSON.parse(readFileSync(0, "utf8")) as { name: string; program: string }[];
const said: Record<string, string> = {};
for (const { name, program } of ways) {
  try {
    // A broken interpreter answers nothing.
    said[name] = run(program) ?? "closed: broken";
  } catch (error) {
    said[name] = `closed: ${error}`;
  }
  if (said[name].startsWith("closed: ")) break;
}
writeSync(1, JSON.stringify(said));
exit(0);
