/**
 * How large the program's text is, as chosen on this device. May import `ui`.
 */
import { recall, remember } from "../ui/dom.ts";

const SIZES_PX = [12, 13, 14, 16, 18, 20, 24];

/** Sets the size the reader chose before, if they did; the style sheet's own is for the others. */
export function applyCodeSize(lab: HTMLElement): void {
  const kept = SIZES_PX.find((px) => String(px) === recall("code-size"));
  if (kept) lab.style.setProperty("--code-size", `${kept}px`);
}

/** One size up (+1) or down (-1) from what is shown. */
export function changeCodeSize(lab: HTMLElement, by: 1 | -1): void {
  const now = Number.parseFloat(getComputedStyle(lab).getPropertyValue("--code-size"));
  const index = SIZES_PX.findIndex((px) => px >= now);
  const px = SIZES_PX[Math.max(0, Math.min(index + by, SIZES_PX.length - 1))];
  if (!px) return;
  remember("code-size", String(px));
  lab.style.setProperty("--code-size", `${px}px`);
}
