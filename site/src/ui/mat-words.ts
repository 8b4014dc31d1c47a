/**
 * The words of the world editor and of mats that come in files and links; `strings.ts` has the rest
 * and the voice. Imports `counted`.
 */
import { counted } from "./counted.ts";

const cm = (value: number): string => String(Math.round(value * 100) / 100);
const point = (x: number, y: number): string => `(${cm(x)}, ${cm(y)})`;
const things = (count: number): string =>
  count === 0 ? "no obstacles" : counted(count, "obstacle");

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
  name: string;
}

export const matFileWords = {
  tooLarge: (name: string) => `${name} takes more than 100 kB, so it is no mat.`,
  noText: (name: string) => `${name} could not be read as text, so it is no mat.`,
  notMat: (name: string, why: string) => `${name} is not a mat, or it is damaged: ${why}.`,
  notJson: "it is not JSON",
  brokenLink:
    "The mat in this link cannot be read: the link is damaged or cut short. Ask for it again, or for the mat as a file.",
  longLink: "The mat in this link takes more than 100 kB, so it is not opened.",
  notMatLink: (why: string) => `The mat in this link cannot be used: ${why}.`,
};

export const matWords = {
  newTitle: "My mat",
  description: "A mat made in the world editor.",
  copyTitle: (title: string) => `${title}, changed`,

  title: "Name",
  about: "What it is good for",
  undo: "Undo",
  redo: "Redo",
  tryIt: "Try it in the lab",
  snap: (grid: number) => `Snap to ${grid} cm`,
  addBox: "Add a box",
  duplicate: "Duplicate",
  remove: "Delete",
  save: "Save as a file",
  open: "Open a file…",
  share: "Share as a link…",
  keys: "Keys",

  mat: "Mat",
  help: "Arrow keys move what is chosen by 1 cm, with Control by 5. Shift and an arrow change its size, or turn the robot. Page Down and Page Up choose the next and the one before. N adds a box, D makes a copy, Delete deletes, Escape lets go.",
  ask: "Drag on the mat to draw a wall or a box. Drag things to move them, and their handles to change their size.",
  askKeys: "Without a mouse: N adds a box, Page Down chooses, the arrow keys move.",
  onMat: "On the mat",
  robotCapital: "Robot",
  x: "x",
  y: "y",
  width: "Width",
  height: "Height",
  heading: "Heading",
  unitCm: "cm",
  unitDegrees: "°",
  word: "Word for it",
  camera: "A camera above the mat tells the robot where it is",
  cameraHelp: "Without it position() and heading() are refused: only odometry() is left.",
  chooseOne: "Choose something on the mat or in the list to set it to the centimetre.",
  corner: "x and y are those of its lower left corner.",

  /** One line for a thing or the robot. */
  size: ({ width, height }: Box) => `${cm(width)} × ${cm(height)} cm`,
  place: ({ x, y }: { x: number; y: number }) => `at ${point(x, y)}`,
  story: ({ name, width, height, x, y }: Box) =>
    `${name}: ${cm(width)} cm wide, ${cm(height)} cm high, lower left corner at ${point(x, y)} cm`,
  robotStory: (x: number, y: number, heading: number) =>
    `robot: at ${point(x, y)} cm, heading ${cm(heading)}°`,
  degrees: (heading: number) => `heading ${cm(heading)}°`,
  described: (boxes: readonly Box[], robot: string) =>
    `A mat of 200 by 200 cm with ${things(boxes.length)}. ${robot}.${boxes
      .map((box) => ` ${matWords.story(box)}.`)
      .join("")}`,

  /** What is said once something has been done. */
  added: (name: string) => `Added: ${name}.`,
  deleted: (name: string) => `Deleted: ${name}.`,
  letGo: "Nothing is chosen.",
  undone: "Undone.",
  redone: "Done again.",
  nothingToUndo: "There is nothing to undo.",
  nothingToRedo: "There is nothing to do again.",
  full: (most: number) => `A mat holds ${counted(most, "obstacle")} at most.`,
  saved: (name: string) =>
    `${name} is saved. Put it into a lesson’s worlds folder, or run a program on it: python -m bugbot run program.py --world ${name}.`,
  opened: (name: string) => `This is the mat of ${name}, kept with yours from now on.`,
  openedBefore: (name: string) => `You have the mat of ${name} already: here it is.`,
  notKept:
    "This browser does not let the site keep your mats, so save this one as a file before you leave.",
  elsewhere: "This mat has been changed in another tab; Undo brings yours back.",
  unknown:
    "The mat that this address asks for is not on this device. Ask for it as a link or a file.",

  /** A number or a word that can't be used; the one before comes back. */
  badNumber: (field: string, low: number, high: number, unit: string) =>
    `${field} takes a number from ${cm(low)} to ${cm(high)} ${unit}.`,
  thin: (field: string, least: number) =>
    `${field}: at least ${least} cm. Anything thinner is easily missed by a beam.`,
  badText: (field: string) => `${field} takes one line of text, at most 300 characters.`,

  /** What is wrong with the mat, or worth knowing. */
  checks: "Check of the mat",
  inTheWay: (name: string, short: number) =>
    `The robot stands in the ${name}. Move one of them ${short.toFixed(1)} cm or more away.`,
  shutIn:
    "The robot is shut in: it has no room to drive anywhere. It needs a passage wider than 10 cm.",
  partly: (percent: number) =>
    `The robot can drive to ${percent} % of the places where it fits. Behind the rest no passage is wider than 10 cm.`,
  bare: "The mat is bare. Draw a wall for the robot to find.",
  fine: "Fine: the robot can drive to every place where it fits.",
};

export const ownMatsWords = {
  title: "Your mats",
  none: "None yet. A mat is kept here, on this device only, from your first change to it.",
  lead: "Kept on this device only. In the lab they are at the end of the list of worlds.",
  open: (title: string) => `Open ${title}`,
  remove: (title: string) => `Delete ${title}`,
  removed: (title: string) => `${title} is deleted.`,
  undo: "Undo",
  back: (title: string) => `${title} is back.`,
  current: "open above",
  facts: (count: number, date: Date) =>
    `${things(count)} · ${date.toLocaleDateString("en-GB", { day: "numeric", month: "short", year: "numeric" })}`,
  start: "Start a new one from",
  bare: "An empty mat",
  make: "New mat",
  made: (title: string) => `This is a new mat, made from: ${title}.`,
};

export const matShareWords = {
  title: "Share this mat",
  lead: "The link holds the whole mat. Nothing is stored anywhere else, and whoever opens it sees the mat first.",
  save: matWords.save,
};

export const offeredMatWords = {
  title: "Somebody shared a mat",
  lead: (title: string, count: number) => `${title}: ${things(count)}.`,
  program: "The link also holds a program. You will see it next, before it is opened.",
  keeps: "If you take it, it is kept with your mats on this device.",
  take: "Take this mat",
  refuse: "Leave it",
};

export const labMatWords = {
  make: "Make your own mat",
  edit: "Edit this mat",
  gone: (used: string) =>
    `This address asks for a mat of somebody’s own. It is not on this device, so this is ${used}. Ask for the mat as a link, or choose another world:`,
  changed: "This mat has been changed in the world editor.",
  show: "Show it",
};

const isMac = /Mac|iPhone|iPad/.test(globalThis.navigator?.userAgent ?? "");
const mod = isMac ? "⌘" : "Ctrl+";
const shift = isMac ? "⇧" : "Shift+";

export const matKeyWords = {
  title: "Keys of the world editor",
  groups: [
    {
      title: "On the mat, and in its list",
      keys: [
        ["← → ↑ ↓", "moves what is chosen by 1 cm"],
        [isMac ? "⌃ and an arrow" : "Ctrl and an arrow", "moves it by 5 cm"],
        [`${shift}arrow`, "moves its right or upper side by 1 cm; turns the robot by 15°"],
        ["Page Down, Page Up", "chooses the next, the one before"],
        ["N", "adds a box"],
        ["D", "makes a copy beside it"],
        ["Delete", "deletes it"],
        ["Esc", "lets go of it, or gives up what is being dragged"],
        [`${mod}Z`, "undoes"],
        [isMac ? "⌘⇧Z" : "Ctrl+Y", "does again what was undone"],
      ],
    },
  ],
};
