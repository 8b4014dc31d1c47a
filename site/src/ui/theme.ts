/**
 * Light, dark, or as the device says. Imports nothing of ours but `dom`.
 *
 * The choice is an attribute of the root element that `base.css` turns into a colour scheme.
 * `early/early.ts` sets the same attribute before the first paint.
 */
import { recall, remember } from "./dom.ts";

export const THEMES = ["system", "light", "dark"] as const;
export type Theme = (typeof THEMES)[number];

export function currentTheme(): Theme {
  const kept = recall("theme");
  return THEMES.find((theme) => theme === kept) ?? "system";
}

export function setTheme(theme: Theme): void {
  remember("theme", theme);
  applyTheme(theme);
}

/** Ink on paper is the light theme, whatever the screen has. */
export function printInLight(): void {
  const { dataset } = document.documentElement;
  let before: string | undefined;
  addEventListener("beforeprint", () => {
    before = dataset.theme;
    applyTheme("light");
  });
  // Not the kept choice: a page in a frame has the theme that the frame asked for.
  addEventListener("afterprint", () =>
    applyTheme(THEMES.find((name) => name === before) ?? "system"),
  );
}

function applyTheme(theme: Theme): void {
  const root = document.documentElement;
  if (theme === "system") root.removeAttribute("data-theme");
  else root.setAttribute("data-theme", theme);
}
