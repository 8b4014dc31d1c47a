/** What a value from elsewhere is, before anything is read of it. Imports nothing of ours. */

export function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** A list of at most so many, all of which hold. */
export function isList(
  value: unknown,
  most: number,
  holds: (item: unknown) => boolean,
): value is unknown[] {
  return Array.isArray(value) && value.length <= most && value.every(holds);
}
