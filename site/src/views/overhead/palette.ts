/**
 * The mat's colours and letters, from the design tokens. May import `views/tokens`.
 */
import { tokenColours } from "../tokens.ts";

const TOKENS = {
  ink: "--ink-soft",
  mat: "--mat",
  grid: "--mat-grid",
  truth: "--mat-truth",
  truthEdge: "--mat-truth-edge",
  wall: "--mat-wall",
  robot: "--mat-robot",
  nose: "--mat-robot-nose",
  cursor: "--mat-cursor",
  bump: "--mat-bump",
  differs: "--mat-differs",
  dim: "--mat-dim",
} as const;

export type Palette = Readonly<Record<keyof typeof TOKENS | "font", string>>;

/** The tokens as they are now for an element. */
export function readPalette(element: HTMLElement): Palette {
  return { ...tokenColours(element, TOKENS), font: getComputedStyle(element).fontFamily };
}
