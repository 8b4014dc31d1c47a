/**
 * The words of the live figures. Imports `counted`.
 *
 * The same voice as `strings.ts`: what is so, in plain words, with its unit.
 */
import { counted } from "./counted.ts";

/** A number with so many digits after its point, a real minus, and a plus where it is asked for. */
export function signed(value: number, digits: number, plus = ""): string {
  const text = Math.abs(value).toFixed(digits);
  if (Number(text) === 0) return text;
  return `${value < 0 ? "−" : plus}${text}`;
}

/** The same with two digits at most, as such numbers are given: −0.4, +8. */
function given(value: number): string {
  const digits = [0, 1].find((few) => Number(value.toFixed(few)) === Number(value.toFixed(2))) ?? 2;
  return signed(value, digits, "+");
}

export const beamWords = {
  picture: "Beam over a grid of cells",
  help: (cell: number) => `Each square is a cell of ${cell} cm.`,
  drag: "Drag the robot or the end of its beam, or move them with the arrow keys (with Shift, a cell at a time).",
  robot: "Robot",
  end: "End of the beam",
  place: (x: number, y: number, reading: number) =>
    `${x} cm right, ${y} cm up; the sensor reads ${reading.toFixed(0)} cm`,

  rules: "How the cells are found",
  half: "Half-cell steps",
  whole: "Whole-cell steps",
  bresenham: "Bresenham’s line",
  /** What a rule comes to, beside its name. */
  tally: (cells: number, missed: number, beside: number) =>
    `${counted(cells, "cell")}, ${missed} missed${beside > 0 ? `, ${beside} beside the beam` : ""}`,

  reading: (cm: number) => `The sensor reads ${cm.toFixed(0)} cm.`,
  found: (clear: number) =>
    `The floor counts as free for ${clear.toFixed(0)} cm, one cell short of the hit.`,
  tooClose: "That is less than a cell away, so no floor counts as free.",
  nothing: (far: number) =>
    `That is ${far} cm or more, so there is no hit, and the floor counts as free for ${far} cm.`,
  steps: (looks: number, step: number, cells: number, more: string) =>
    `${counted(looks, "look")}, ${step} cm apart, name ${counted(cells, "cell")}. ${more}`,
  line: (cells: number, beside: number, more: string) =>
    `The line names ${counted(cells, "cell")}, each once${beside > 0 ? `, ${beside} of which the beam does not cross` : ""}. ${more}`,
  more: (cells: number, longest: number) => {
    if (cells === 0) return "The beam crosses no others.";
    const most = `${longest.toFixed(1)} cm`;
    return cells === 1
      ? `The beam crosses 1 more, for ${most}.`
      : `The beam crosses ${cells} more, for at most ${most} each.`;
  },

  legend: "Marks in the picture",
  free: "free",
  hit: "hit",
  look: "look",
  missed: "crossed but missed",
  beside: "named, not crossed",

  examples: "Examples",
  slant: "A slant",
  row: "Along a row",
  far: "Nothing in range",
};

export const evidenceWords = {
  picture: "The cell’s log odds and its probability on two number lines",
  readout: { logOdds: "log odds", p: "probability", call: "the map says" },
  logOdds: "Log odds: each hit is a step of one length",
  p: "Probability: the same steps shrink towards 0 and 1",
  occupied: "occupied",
  free: "free",
  unknown: "unknown",

  controls: "Evidence",
  hit: "Hit",
  pass: "Pass",
  hits: (times: number) => counted(times, "hit"),
  passes: (times: number) => counted(times, "pass", "passes"),
  undo: "Undo",
  again: "Start again",

  numbers: "Numbers of",
  ours: "this page",
  octomap: "OctoMap",
  cartographer: "Cartographer (2D)",
  hector: "hector_mapping",
  adds: (hit: number, pass: number) => `A hit adds ${given(hit)}, a pass ${given(pass)}.`,
  kept: (low: number, high: number) =>
    `The sum is kept between ${given(low)} and ${given(high)} (the bars).`,
  stops: (high: number) =>
    `At ${high} or more (the bar) a hit adds nothing; there is no lower limit.`,
  ourCalls: "Above +1 the map says occupied, below −1 free.",
  calls: "Above 0 the map says occupied, below 0 free.",
  noCalls:
    "Its maps hold the probability itself; here occupied means above 0.5 and free means below.",

  nothingYet: "No evidence yet: the log odds are 0, and the probability of a wall is 0.5.",
  state: (hits: number, passes: number, l: number, p: number, call: string) =>
    `${counted(hits, "hit")} and ${counted(passes, "pass", "passes")} come to log odds of ${signed(l, 2)}, a probability of ${p.toFixed(3)}: ${call}.`,
  held: "That is as far as it goes.",
  undoneBy: (times: number, what: "hit" | "pass") =>
    `${what === "hit" ? counted(times, "hit") : counted(times, "pass", "passes")} in a row would undo it.`,
  even: "The evidence for a wall and against it is even.",
};
