/**
 * The words of the noise: which seed a run has, many runs of one program, and runs from elsewhere.
 * Imports `counted`.
 */
import { counted } from "./counted.ts";

export const noiseWords = {
  name: "Noise",
  help: "The same seed gives the same sensor noise, so the same run.",
  same: "Same noise",
  fresh: "New noise",
};

/** Of a run that the page shows in a lab that did not make it. */
export const guestWords = {
  back: "Back to your run",
};

export const repeatWords = {
  /** Where there is little room, the second word is left out. */
  start: (times: number) => `Repeat ${times}`,
  times: "times",
  help: (times: number) =>
    `Runs the program with ${counted(times, "seed")}, to tell luck from skill.`,
  cancel: "Cancel",
  goingOn: "Repeating with other noise…",
  count: (done: number, of: number) => `${done} of ${of}`,
  run: (seed: number, values: string) => `Seed ${seed} finished${values && `: ${values}`}`,
  failed: (seed: number) => `Seed ${seed} ended with an error`,
  limit: (seed: number, message: string) => `Seed ${seed}: ${message}`,
  stopped: (seed: number) => `The run with seed ${seed} ended like this, so the rest are left out.`,
  summary: (runs: number) => `${counted(runs, "run ends", "runs end")} at:`,
  line: (name: string, median: string, low: string, high: string) =>
    `${name}: median ${median}, from ${low} to ${high}`,
};
