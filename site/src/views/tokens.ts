/**
 * The design tokens for canvases, which cannot read custom properties by themselves.
 * Imports nothing of ours.
 */

/** The colours that these tokens ("--mat", …) stand for at an element now, in a canvas's terms. */
export function tokenColours<Name extends string>(
  element: HTMLElement,
  tokens: Readonly<Record<Name, string>>,
): Record<Name, string> {
  const probe = document.createElement("span");
  probe.hidden = true;
  element.append(probe);
  const computed = getComputedStyle(probe);
  const colours = { ...tokens } as Record<Name, string>;
  for (const name of Object.keys(tokens) as Name[]) {
    probe.style.color = `var(${tokens[name]})`;
    colours[name] = computed.color;
  }
  probe.remove();
  return colours;
}
