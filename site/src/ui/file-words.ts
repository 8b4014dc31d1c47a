/**
 * The words for files, links and earlier versions; `strings.ts` has the rest and the voice.
 * Imports `dom` for the forms of numbers.
 */
import { counted } from "./counted.ts";
import { megabytes } from "./dom.ts";

const size = (bytes: number): string => {
  if (bytes < 1000) return `${bytes} B`;
  return bytes < 1e6 ? `${(bytes / 1000).toFixed(1)} kB` : `${megabytes(bytes)} MB`;
};

const lines = (text: string): string => {
  const count = text.split("\n").length - (text.endsWith("\n") ? 1 : 0);
  return counted(count, "line");
};

export const menuWords = {
  program: "Program",
  versions: "Earlier versions…",
  open: "Open a .py file…",
  save: "Save as a .py file",
  share: "Share as a link…",
  run: "This run",
  saveRun: "Save the run as a file",
  openRun: "Open a saved run…",
  chart: "Save the chart as CSV",
  picture: "Save the picture as PNG",
  print: "Print…",
};

export const dialogWords = {
  close: "Close",
  preview: "Preview",
};

export const fileWords = {
  opened: (name: string) => `This is ${name}.`,
  same: (name: string) => `${name} holds the program that is here already.`,
  unreadable: (name: string) => `${name} could not be read. Is it a folder, or has it been moved?`,
  tooLarge: (name: string, bytes: number) =>
    `${name} takes ${size(bytes)}. A program may take 1 MB at most.`,
  notText: (name: string) => `${name} does not hold text, so it is no Python program.`,
  runTooLarge: (name: string, bytes: number) =>
    `${name} takes ${size(bytes)}. A saved run may take 160 MB at most.`,
  notRun: (name: string, why: string) => `${name} is not a saved run, or it is damaged: ${why}.`,
  noText: "it does not hold text",
  noEnd: "the run in it has no end",
  run: (world: string, seed: number) => `This is a saved run: ${world}, seed ${seed}.`,
  takeProgram: "Open its program",
};

export const versionWords = {
  title: "Earlier versions",
  lead: "Kept on this device at each run, and before the program was replaced.",
  none: "There are none yet. A version is kept each time you press Run, and before the program is replaced.",
  untouched:
    "There are none yet: this is still the page's own program. Once you have changed it, each Run keeps the version it ran.",
  onlyThis:
    "There is none but this one: the program as it is now has been kept. Once you change it, you can come back to it here.",
  list: "Versions, newest first",
  restore: "Bring this one back",
  restored: "The earlier version is back.",
  size: lines,
  /** What is different from the program in the editor. */
  change: (line: number, text: string) => `line ${line}: ${text.trim() || "(empty)"}`,
  removed: (line: number) => `lines removed at line ${line}`,
  day: (at: Date, now: Date): string => {
    const midnight = (date: Date) => new Date(date).setHours(0, 0, 0, 0);
    const days = Math.round((midnight(now) - midnight(at)) / 86_400_000);
    if (days === 0) return "Today";
    if (days === 1) return "Yesterday";
    return at.toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" });
  },
  time: (at: Date) => at.toLocaleTimeString("en-GB", { hour: "2-digit", minute: "2-digit" }),
};

export const shareWords = {
  title: "Share this program",
  lead: "The link holds the program, the world and the seed. Nothing is stored anywhere else, and whoever opens it is asked first.",
  link: "Link",
  copy: "Copy link",
  copied: "The link is copied.",
  notCopied:
    "This browser did not let the page copy. The link is selected: copy it from the field.",
  long: (length: number) =>
    `The link has ${counted(length, "character")}. Some mail and chat programs cut links this long: a file is safer.`,
  save: menuWords.save,
  broken:
    "The program in this link cannot be read: the link is damaged or cut short. Ask for it again, or for the program as a file.",
  tooLarge:
    "The program in this link takes more than 1 MB, so it is not opened. Ask for it as a file.",
  offered: "Somebody shared a program",
  offer: (program: string, world: string, seed: number) =>
    `${lines(program)} (${size(new Blob([program]).size)}) for ${world}, seed ${seed}. Read it before you open it; it runs only when you press Run. Your own program here goes into the earlier versions.`,
  take: "Open this program",
  keep: "Keep mine",
  taken: "This is the shared program. Press Run to try it.",
  same: "The link holds the program that is here already.",
};

/** The menu's part about ROS maps; what is said of one is in `ros-words.ts`. */
export const mapMenuWords = {
  map: "Map",
  save: "Download as ROS map",
  /** `moment` is the shown one [s], or null at the end of the run. */
  saveAt: (moment: number | null) =>
    `Download as ROS map, as at ${moment === null ? "the end of the run" : `${moment.toFixed(1)} s`}`,
  open: "Open a ROS map…",
  remove: "Remove the ROS map",
  working: "Python is making the map…",
  reading: "Python is reading the map…",
};
