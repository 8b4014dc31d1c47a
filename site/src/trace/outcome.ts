/**
 * The summary of a finished run, equal to `bugbot.run.outcome_of` in Python (a test holds them
 * equal). Imports the trace.
 */
import { type Layer, type Outcome, POINTS_PER_CM } from "./events.ts";
import type { Trace } from "./trace.ts";

/** Throws an Error for a run that has not ended. */
export function outcomeOf(trace: Trace): Outcome {
  const { end, fault } = trace;
  if (!end) throw new Error("outcomeOf needs a run that has ended");
  const { x, y, heading } = trace.poseAt(end.t);
  return {
    status: end.status,
    message: end.message,
    seconds: end.t,
    console: trace.consoleText(end.t),
    notes: trace.notes.map(({ line, text }) => ({ line, text })),
    pose: { x, y, heading },
    series: Object.fromEntries(
      Array.from(trace.series, ([name, { t, value }]) => [
        name,
        Array.from(t.view(), (time, i): [number, number] => [time, value.at(i)]),
      ]),
    ),
    layers: Object.fromEntries(
      trace.layersAt(end.t).map((layer) => [layer.name, layerOf(trace, layer)]),
    ),
    fault: fault && {
      type: fault.type,
      message: fault.message,
      line: fault.line,
      hint: fault.hint,
    },
  };
}

function layerOf(trace: Trace, layer: Layer): Outcome["layers"][string] {
  const stored = trace.pointsOf(layer);
  const points: [number, number][] = [];
  for (let i = 0; i < stored.length; i += 2) {
    points.push([Number(stored[i]) / POINTS_PER_CM, Number(stored[i + 1]) / POINTS_PER_CM]);
  }
  const { shape, size, colour, texts } = layer;
  return { shape, size, colour, points, ...(texts && { texts: [...texts] }) };
}
