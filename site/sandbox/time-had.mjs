/**
 * The time that a process has had of the processor. Imports nothing.
 */

/** So much passes by the clock before the two are compared anew [ms]. */
const STEP_MS = 50;

/**
 * A clock that runs as the clock on the wall does while the process computes, and slower while it has to
 * wait; threads that compute beside it do not make it faster.
 * @param {() => number} wall [ms]
 * @param {() => number} processor [ms], of all threads together
 * @returns {() => number} [ms]
 */
export function timeHad(wall, processor) {
  let had = wall();
  let [lastWall, lastProcessor] = [had, processor()];
  return () => {
    const [nowWall, nowProcessor] = [wall(), processor()];
    const now = had + Math.min(nowWall - lastWall, nowProcessor - lastProcessor);
    if (nowWall - lastWall >= STEP_MS) {
      had = now;
      [lastWall, lastProcessor] = [nowWall, nowProcessor];
    }
    return now;
  };
}
