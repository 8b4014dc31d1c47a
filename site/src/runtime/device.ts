/**
 * What the device at hand can do: whether Python can run in it, and how many interpreters it can bear.
 * Imports nothing of ours.
 */

/** What browsers tell of a device; Safari and Firefox tell no memory. */
export interface Device {
  userAgent: string;
  maxTouchPoints: number;
  /** [GB], rounded, and 8 at most. */
  deviceMemory?: number;
}

/** So much memory is little: an interpreter takes some 100 MB, and a browser has other tabs [GB]. */
const LITTLE_GB = 4;

/**
 * Whether to have no more interpreters than the one that works. iPhones and iPads tell no memory, and end
 * a page that takes much of it.
 */
export function isSmall(device: Device): boolean {
  const { userAgent, maxTouchPoints, deviceMemory } = device;
  const isIos = /iPhone|iPod|iPad/.test(userAgent);
  // An iPad says that it is a Mac; Macs have no screens to touch.
  const isPad = /Macintosh/.test(userAgent) && maxTouchPoints > 1;
  return isIos || isPad || (deviceMemory !== undefined && deviceMemory <= LITTLE_GB);
}

/** What keeps Python from running here, in words; null if nothing is known to. */
export function obstacle(world: { WebAssembly?: unknown; Worker?: unknown }): string | null {
  if (!world.WebAssembly) {
    return "it needs WebAssembly, which is switched off in this browser (iPhones do that in Lockdown Mode)";
  }
  if (!world.Worker) return NO_WORKERS;
  return null;
}

const NO_WORKERS = "it needs a worker, and this browser does not let pages start any";
const NO_MEMORY =
  "this device has too little memory free for it. Close other tabs and programs, then try again";

/** Why an interpreter could not be started, in words where there are some. */
export function inWords(error: unknown): string {
  const text = error instanceof Error ? error.message : String(error);
  // It may come from the frame that workers are made in, whose DOMException is another class.
  if (Object(error).name === "SecurityError") return NO_WORKERS;
  return /out of memory|could not allocate|allocation failed/i.test(text) ? NO_MEMORY : text;
}
