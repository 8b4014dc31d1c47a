/** The words of the path through the lessons; `strings.ts` has the rest and the voice. */
export const courseWords = {
  passed: (passed: number, of: number) =>
    passed === 0 ? `${of}` : passed === of ? `all ${of} passed` : `${passed} of ${of} passed`,
  done: (passed: number, of: number) =>
    passed === of ? `Done: all ${of} tasks passed` : `${passed} of ${of} tasks passed`,
  goOn: (title: string) => `Continue where you left: ${title}`,
};
