/** The filters of a PNG file's rows, undone: bytes filtered here come back. */
import { expect, test } from "@playwright/test";
import { undoFilters } from "../../site/src/worker/png-rows.ts";

const WIDTH = 13;

/** Rows of noise, the same at each run. */
function noise(rows: number): Uint8Array[] {
  let state = 1;
  return Array.from({ length: rows }, () =>
    Uint8Array.from({ length: WIDTH }, () => {
      state = (state * 48271) % 2147483647;
      return state & 255;
    }),
  );
}

/** What section 9 of the specification has taken away from a byte, given its neighbours. */
const GUESSES: ((left: number, up: number, corner: number) => number)[] = [
  () => 0,
  (left) => left,
  (_, up) => up,
  (left, up) => Math.floor((left + up) / 2),
  (left, up, corner) => {
    const near = (value: number) => Math.abs(left + up - corner - value);
    return [left, up, corner].reduce((best, each) => (near(each) < near(best) ? each : best));
  },
];

for (const pixelBytes of [1, 3, 4]) {
  test(`each filter of a row is undone, with ${pixelBytes} bytes a pixel`, () => {
    const rows = noise(11);
    const filtered = rows.flatMap((row, y) => {
      const filter = y % GUESSES.length;
      const above = rows[y - 1] ?? new Uint8Array(WIDTH);
      const bytes = Array.from(row, (byte, i) => {
        const [left, corner] = [row[i - pixelBytes] ?? 0, above[i - pixelBytes] ?? 0];
        return (byte - (GUESSES[filter]?.(left, above[i] ?? 0, corner) ?? 0)) & 255;
      });
      return [filter, ...bytes];
    });
    const data = Uint8Array.from(filtered);
    undoFilters(data, WIDTH, pixelBytes);
    expect(rows.map((_, y) => data.subarray(y * (WIDTH + 1) + 1, (y + 1) * (WIDTH + 1)))).toEqual(
      rows,
    );
  });
}
