/**
 * One cell and what speaks for it: log odds, added up by the numbers of this page or of a system
 * that is in use. Imports nothing.
 *
 * Sources of the numbers: `mapping/log_odds.py`; OctoMap, AbstractOccupancyOcTree.cpp;
 * Cartographer, trajectory_builder_2d.lua and probability_values.h; hector_slam, GridMapLogOdds.h
 * and the parameters update_factor_occupied and update_factor_free.
 */

export interface Numbers {
  /** Log odds that a hit and a pass add. */
  hit: number;
  pass: number;
  /** Log odds stay between these. */
  low: number;
  high: number;
  /** The sum may go over `high` by less than one hit, because it is not cut off but left. */
  overshoots: boolean;
  /** A cell is free below the one and occupied above the other. */
  free: number;
  occupied: number;
}

export const SYSTEMS = {
  ours: {
    hit: 0.85,
    pass: -0.4,
    low: -8,
    high: 8,
    overshoots: false,
    free: -1,
    occupied: 1,
  },
  octomap: {
    hit: logOdds(0.7),
    pass: logOdds(0.4),
    low: logOdds(0.1192),
    high: logOdds(0.971),
    overshoots: false,
    free: 0,
    occupied: 0,
  },
  cartographer: {
    hit: logOdds(0.55),
    pass: logOdds(0.49),
    low: logOdds(0.1),
    high: logOdds(0.9),
    overshoots: false,
    free: 0,
    occupied: 0,
  },
  hector: {
    hit: logOdds(0.9),
    pass: logOdds(0.4),
    low: Number.NEGATIVE_INFINITY,
    high: 50,
    overshoots: true,
    free: 0,
    occupied: 0,
  },
} as const satisfies Record<string, Numbers>;

export type System = keyof typeof SYSTEMS;
export type Evidence = "hit" | "pass";

/** So many hits or passes, one after the other: what one press of a button gives. */
export interface Press {
  what: Evidence;
  times: number;
}

/** Log odds of a probability above 0 and below 1. */
export function logOdds(p: number): number {
  return Math.log(p / (1 - p));
}

export function probability(l: number): number {
  return 1 / (1 + Math.exp(-l));
}

/** Log odds after one more hit or pass. */
export function added(numbers: Numbers, l: number, what: Evidence): number {
  const { hit, pass, low, high, overshoots } = numbers;
  if (what === "pass") return Math.max(low, l + pass);
  if (overshoots) return l < high ? l + hit : l;
  return Math.min(high, l + hit);
}

/** Log odds after each of the presses' hits and passes, from 0. */
export function course(numbers: Numbers, presses: readonly Press[]): number[] {
  const values = [0];
  let l = 0;
  for (const { what, times } of presses) {
    for (let i = 0; i < times; i++) {
      l = added(numbers, l, what);
      values.push(l);
    }
  }
  return values;
}

/** What the cell is taken for. */
export function call({ free, occupied }: Numbers, l: number): "free" | "unknown" | "occupied" {
  if (l > occupied) return "occupied";
  return l < free ? "free" : "unknown";
}

/** How many of the other kind in a row bring the log odds back to 0, or to its other side. */
export function undoing(numbers: Numbers, l: number): Press | null {
  if (Math.abs(l) < SLACK) return null;
  const what = l > 0 ? "pass" : "hit";
  const step = Math.abs(l > 0 ? numbers.pass : numbers.hit);
  return { what, times: Math.ceil(Math.abs(l) / step - SLACK) };
}

/** Sums of 0.85 and 0.4 miss 0 by what binary fractions leave. */
const SLACK = 1e-9;
