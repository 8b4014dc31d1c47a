/** Imports nothing of ours. */

/** So many of something: "1 cell", "1,200 cells"; `many` is the plural that is not just an s more. */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${count.toLocaleString("en-GB")} ${count === 1 ? one : many}`;
}
