/** The words of the path through the lessons; `strings.ts` has the rest and the voice. */
import { counted } from "./counted.ts";

export const courseWords = {
  passed: (passed: number, of: number) =>
    passed === 0
      ? `${of}`
      : passed === of && of > 1
        ? `all ${of} passed`
        : `${passed} of ${of} passed`,
  done: (passed: number, of: number) =>
    passed === of && of > 1
      ? `Done: all ${of} tasks passed`
      : `${passed === of ? "Done: " : ""}${passed} of ${counted(of, "task")} passed`,
  goOn: (title: string) => `Continue where you left: ${title}`,
};
