/**
 * Every word of the interface that is not in a page's own HTML, once, in the order one meets them.
 * Imports nothing of ours but `dom` (for the forms of numbers).
 *
 * The voice: say what happened, then what to do; no blame, no exclamation marks.
 */
import { megabytes, seconds } from "./dom.ts";

export const editorWords = {
  name: "Program",
  smaller: "Smaller text",
  larger: "Larger text",
};

export const syntaxWords = {
  string: (quote: string) => `This text starts with ${quote} but never ends with ${quote}.`,
  stray: (sign: string) => `This ${sign} closes nothing: no bracket is open here.`,
  mismatch: (sign: string, opener: string) =>
    `This ${sign} does not match the ${opener} before it.`,
  unclosed: (sign: string) => `This ${sign} is never closed.`,
  print: "print needs brackets: print(…).",
  compare: "To ask whether two values are equal, write == with two signs.",
  orphan: (word: string) =>
    `This ${word} belongs to nothing above it. Is it indented as far as its partner?`,
  empty:
    "This line ends with a colon, so the lines that belong to it must follow, indented by four spaces.",
  colon: (word: string) => `A line that begins with ${word} ends with a colon (:).`,
  unreadable: "Python cannot read this line from here on.",
};

export const labWords = {
  untitled: "Lab",
  more: "More",
  run: "Run",
  stop: "Stop",
  reset: "Reset program",
  resetShort: "Reset",
  undo: "Undo",
  retry: "Try again",
};

export const statusWords = {
  label: "Status of the run",
  cold: "Press Run to start Python and the robot.",
  starting: "Python is starting…",
  bytes: (loaded: number, total: number) => `${megabytes(loaded)} of ${megabytes(total)} MB`,
  ready: "Ready. Press Run.",
  waiting: "Python is still starting. Your program runs as soon as it is up.",
  running: "Running…",
  reached: (t: number) => `${seconds(t)} so far`,
  finished: (t: number) => `Finished at ${seconds(t)}.`,
  stopped: (t: number) => `You stopped the program at ${seconds(t)}.`,
  fault: (line: number | null) =>
    line === null
      ? "The program ended with an error."
      : `An error on line ${line} ended the program.`,
  goTo: (line: number) => `Go to line ${line}`,
  failed: (why: string) => `Python could not start: ${why}`,
  reset: "The program is as it was at the start.",
  restored: "Your program is back.",
  notKept:
    "This browser does not let the site keep your program, so copy it elsewhere before you leave.",
};

export const problemWords = {
  region: "What went wrong",
  cause: "Likely cause:",
  details: (type: string) => `Python calls this a ${type}; show all it says`,
};

export const transportWords = {
  region: "Playback",
  play: "Play",
  pause: "Pause",
  back: "Step back",
  step: "Step",
  time: "Time",
  speed: "Speed",
  times: (speed: number) => `${speed}×`,
  toEnd: "to the end",
  shown: (t: number, duration: number) => `${t.toFixed(1)} of ${seconds(duration)}`,
};

export const pickerWords = {
  world: "World",
  seed: "Seed",
  ownMats: "Your mats",
  ownProgram: (world: string) => `This is the program kept for ${world}.`,
  bring: (world: string) => `Use the one from ${world} here`,
  badSeed: (text: string, most: number, used: number) =>
    `The seed “${text}” is not a whole number from 0 to ${most}. Seed ${used} is used.`,
  unknownWorld: (name: string, used: string) =>
    `There is no world called “${name}”, so this is ${used}. The worlds are:`,
};

export const themeWords = {
  label: "Colours",
  system: "Device",
  light: "Light",
  dark: "Dark",
};

/** What a lab starts from where nobody has written a program for its world. */
export const starterProgram = `from bugbot import *

forward(50, 20)              # per cent of full speed, cm

for angle, cm in scan():     # eight beams, left to right
    print(f"{angle:6.1f} degrees: {cm:5.1f} cm")
`;

/** For a lab in a frame of another site. */
export const embedWords = {
  noWorld: (name: string, there: string): string =>
    `There is no world "${name}" here. There are: ${there}.`,
  /** What the page around the lab has set, and can't be. */
  wrong: (what: "program" | "world" | "seed" | "seek", got: string): string => {
    const wanted = { program: "a text", world: "a name", seed: "a whole number", seek: "a number" };
    return `The page around this lab has given ${got} as its ${what}; it takes ${wanted[what]}. Nothing has changed.`;
  },
  unknown: "The page around this lab has sent something that the lab does not understand.",
};
