/**
 * Small helpers for the page that belong to no one view. Imports nothing of ours.
 */

/** Keeps one small setting on this device; where storage is refused it lasts as long as the page. */
const settings = new Map<string, string>();

export function remember(name: string, value: string): void {
  settings.set(name, value);
  try {
    localStorage.setItem(`bugbot:${name}`, value);
  } catch {
    // Private browsing or full storage: the setting still holds until the page is left.
  }
}

export function recall(name: string): string | null {
  const kept = settings.get(name);
  if (kept !== undefined) return kept;
  try {
    return localStorage.getItem(`bugbot:${name}`);
  } catch {
    return null;
  }
}

/** "13.0 s": the same form at the slider, in the status line and in messages. */
export function seconds(t: number): string {
  return `${t.toFixed(1)} s`;
}

/** A size as "4.2" in millions of bytes; the unit stands once, behind the pair it belongs to. */
export function megabytes(bytes: number): string {
  return (bytes / 1e6).toFixed(1);
}
