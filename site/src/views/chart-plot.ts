/**
 * The chart's uPlot: scales, axes, the look of each line, and seeking with the pointer.
 * May import `chart-data`; colours come from the design tokens.
 */
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { dashOf, joined, type Line, type Role, short } from "./chart-data.ts";
import { tokenColours } from "./tokens.ts";

const TOKENS = {
  ink: "--ink-soft",
  grid: "--line",
  a: "--chart-1",
  b: "--chart-2",
  c: "--chart-3",
  d: "--chart-4",
  e: "--chart-5",
  f: "--chart-6",
} as const;

const WIDTHS: Record<Role, number> = { run: 2.25, earlier: 1, median: 1.5, low: 0, high: 0 };
const ALPHAS: Record<Role, number> = { run: 1, earlier: 0.6, median: 0.9, low: 1, high: 1 };

export interface PlotOptions {
  /** Where the axis of time ends [s]. */
  lastTime(): number;
  onSeek(t: number): void;
}

/** A plot that fills `frame`; `names` gives each line's colour its place. */
export function makePlot(
  frame: HTMLElement,
  lines: readonly Line[],
  names: readonly string[],
  { lastTime, onSeek }: PlotOptions,
): uPlot {
  const colours = tokenColours(frame, TOKENS);
  const lineColours = [colours.a, colours.b, colours.c, colours.d, colours.e, colours.f];
  const colourOf = (name: string): string => lineColours[names.indexOf(name) % 6] ?? colours.ink;
  const axis: uPlot.Axis = {
    stroke: colours.ink,
    font: `11px ${getComputedStyle(frame).fontFamily}`,
    grid: { stroke: colours.grid, width: 1 },
    ticks: { show: false },
    gap: 6,
  };
  const plot = new uPlot(
    {
      width: frame.clientWidth,
      height: frame.clientHeight,
      padding: [8, 14, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: () => [0, lastTime() || 1] },
        y: { range: (_, low, high) => rangeOf(low, high) },
      },
      axes: [
        { ...axis, size: 24, values: (_, ticks) => ticks.map((tick) => `${tick} s`) },
        { ...axis, size: 44, values: (_, ticks) => ticks.map(short) },
      ],
      series: [
        {},
        ...lines.map(
          ({ name, role }): uPlot.Series => ({
            label: name,
            stroke: colourOf(name),
            width: WIDTHS[role],
            alpha: ALPHAS[role],
            dash: [...dashOf(names.indexOf(name))],
            points: { show: false },
          }),
        ),
      ],
      bands: lines.flatMap(({ name, role }, i) =>
        role === "low"
          ? [{ series: [i + 2, i + 1] as [number, number], fill: faint(colourOf(name)) }]
          : [],
      ),
    },
    joined(lines),
    frame,
  );
  for (const mark of ["chart-yet", "chart-now"]) {
    const element = document.createElement("div");
    element.className = mark;
    plot.over.append(element);
  }
  seekWithPointer(plot, onSeek);
  return plot;
}

/** 0 is always on the axis: a share or a count seen without it misleads. */
function rangeOf(low: number | null, high: number | null): [number, number] {
  const from = Math.min(0, low ?? 0);
  const to = Math.max(0, high ?? 0);
  if (from === to) return [0, 1];
  const room = 0.06 * (to - from);
  return [from < 0 ? from - room : 0, to > 0 ? to + room : 0];
}

function seekWithPointer(plot: uPlot, onSeek: (t: number) => void): void {
  const { over } = plot;
  const seek = (event: PointerEvent): void => {
    onSeek(plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
  };
  over.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    over.setPointerCapture(event.pointerId);
    seek(event);
  });
  over.addEventListener("pointermove", (event) => {
    if (over.hasPointerCapture(event.pointerId)) seek(event);
  });
}

/** The same colour, to fill a band with. */
function faint(rgb: string): string {
  return rgb.replace(/^rgb\((.*)\)$/, "rgba($1, 0.16)");
}
