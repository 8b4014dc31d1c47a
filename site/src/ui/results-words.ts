/**
 * The words of a results card. `strings.ts` has the voice. Imports `counted`.
 */
import { counted } from "./counted.ts";

const day = (at: number): string =>
  new Date(at).toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" });

/** A number as it is shown; a real minus sign. */
export const number = (value: number, digits: number): string =>
  value.toFixed(digits).replace("-", "−");

export const resultsWords = {
  title: "Results",
  score: "Score",
  of: (of: number) => `of ${of}`,
  first: "Your first score: now see how far it goes.",
  best: (before: number) => `Your best so far. It was ${number(before, 1)}.`,
  same: "As good as your best.",
  notBest: (best: number, at: number) => `Your best is ${number(best, 1)}, of ${day(at)}.`,
  more: (by: number) => `${number(by, 1)} more than last time.`,
  less: (by: number) => `${number(by, 1)} less than last time.`,
  unchanged: "The same as last time.",
  kept: (kept: number, of: number) =>
    kept === of && of > 1
      ? `All ${of} runs keep to the limits.`
      : `${kept} of ${counted(of, "run keeps", "runs keep")} to the limits.`,
  how: "What counts",
  mat: (title: string) => `Mat “${title}”`,
  truth: "What is really there",
  truthOf: (title: string) => `The mat “${title}” as it really is`,
  seed: (seed: number) => `Seed ${seed}`,
  mapOf: (seed: number, share: Shares) =>
    `Your map with seed ${seed}: ${number(share.free, 0)} % free, ${number(share.occupied, 0)} % occupied, ${number(share.unknown, 0)} % unknown${share.wrong === 0 ? "" : `; ${counted(share.wrong, "cell is", "cells are")} wrong`}`,
  noMap: "No map was drawn.",
  keeps: "Keeps to the limits",
  breaks: "Does not keep to the limits",
  show: "Show this run",
  showOf: (title: string, seed: number) => `Show this run: “${title}”, seed ${seed}`,
  rosMap: "ROS map",
  rosMapOf: (title: string, seed: number) => `Download as ROS map: “${title}”, seed ${seed}`,
  figures: (title: string) => `Figures of the runs on “${title}”`,
  figure: "Figure",
  limit: "Limit",
  points: "Points",
  atLeast: (value: string) => `at least ${value}`,
  atMost: (value: string) => `at most ${value}`,
  none: "none",
  noLimit: "–",
  notMet: "outside the limit",
  up: (by: string) => `${by} more than last time`,
  down: (by: string) => `${by} less than last time`,
  legend: "In the maps",
  free: "free",
  occupied: "occupied",
  unknown: "unknown",
  wrong: "wrong: a wall where nothing is, or floor inside something solid",
  path: "the robot’s way",
};

export interface Shares {
  free: number;
  occupied: number;
  unknown: number;
  wrong: number;
}
