/**
 * The constants of a program that is in no editor. May import `numbers`.
 */
import { pythonLanguage } from "@codemirror/lang-python";
import { type Constant, constantsOf } from "./numbers.ts";

/** Every `NAME = number` at the program's top level, in order. */
export function constantsIn(program: string): Constant[] {
  return constantsOf(pythonLanguage.parser.parse(program), program);
}
