/**
 * The mat's colours for the canvas, from the design tokens, which a canvas cannot read by itself.
 * Imports nothing of ours.
 */
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
  const probe = document.createElement("span");
  probe.hidden = true;
  element.append(probe);
  const computed = getComputedStyle(probe);
  const colours = Object.entries(TOKENS).map(([name, token]) => {
    probe.style.color = `var(${token})`;
    return [name, computed.color];
  });
  probe.style.fontFamily = "var(--ui)";
  const palette = { ...Object.fromEntries(colours), font: computed.fontFamily };
  probe.remove();
  return palette;
}
