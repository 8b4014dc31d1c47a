/**
 * The figures of the runs on one mat as a table: a row for each figure with its limit, a column for
 * each run, and how it has changed since the attempt before. May import `runtime` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import type { Figure, Result } from "../runtime/results.ts";
import { icons } from "../ui/icons.ts";
import { number, resultsWords as words } from "../ui/results-words.ts";

/** `before` finds the same run of the attempt before, if there was one. */
export function figureTable(
  runs: readonly Result[],
  before: (run: Result) => Result | undefined,
): TemplateResult {
  const [first] = runs;
  if (!first) return html``;
  const scored = runs.some(({ points }) => points !== null);
  return html`<div class="result-figures" role="region" tabindex="0"
    aria-label=${words.figures(first.world.title)}>
    <table>
      <caption>${words.figures(first.world.title)}</caption>
      <thead>
        <tr>
          <th scope="col">${words.figure}</th>
          <th scope="col">${words.limit}</th>
          ${runs.map(({ seed }) => html`<th scope="col">${words.seed(seed)}</th>`)}
        </tr>
      </thead>
      <tbody>
        ${first.figures.map(
          (figure) => html`<tr>
            <th scope="row">${figure.name}</th>
            <td>${limitOf(figure)}</td>
            ${runs.map((run) => cellOf(named(run, figure.name), named(before(run), figure.name)))}
          </tr>`,
        )}
        ${scored ? pointsRow(runs, before) : nothing}
      </tbody>
    </table>
  </div>`;
}

function pointsRow(
  runs: readonly Result[],
  before: (run: Result) => Result | undefined,
): TemplateResult {
  return html`<tr class="points">
    <th scope="row">${words.points}</th>
    <td>${words.noLimit}</td>
    ${runs.map((run) => {
      const earlier = before(run)?.points ?? null;
      return run.points === null
        ? html`<td>${words.none}</td>`
        : html`<td>${number(run.points, 1)}${change(run.points, earlier, 1, "")}</td>`;
    })}
  </tr>`;
}

function named(run: Result | undefined, name: string): Figure | undefined {
  return run?.figures.find((figure) => figure.name === name);
}

function withUnit(value: string, unit: string): string {
  return unit ? `${value} ${unit}` : value;
}

export function limitOf({ at_least, at_most, unit }: Figure): string {
  const limits = [
    ...(at_least === null ? [] : [words.atLeast(withUnit(plain(at_least), unit))]),
    ...(at_most === null ? [] : [words.atMost(withUnit(plain(at_most), unit))]),
  ];
  return limits.length > 0 ? limits.join(", ") : words.noLimit;
}

/** A limit as its author wrote it. */
function plain(value: number): string {
  return String(value).replace("-", "−");
}

function cellOf(figure: Figure | undefined, before: Figure | undefined): TemplateResult {
  if (!figure || figure.value === null) return html`<td>${words.none}${sign(figure)}</td>`;
  const { value, digits, unit, met } = figure;
  return html`<td data-met=${met === null ? "" : String(met)}>
    ${withUnit(number(value, digits), unit)}${sign(figure)}${change(value, before?.value ?? null, digits, unit)}
  </td>`;
}

function sign(figure: Figure | undefined): TemplateResult | typeof nothing {
  if (figure?.met !== false) return nothing;
  return html` ${icons.failed}<span class="out-of-sight">, ${words.notMet}</span>`;
}

/** Since the attempt before; nothing if it rounds to nothing. */
function change(
  value: number,
  before: number | null,
  digits: number,
  unit: string,
): TemplateResult | typeof nothing {
  if (before === null) return nothing;
  const by = number(Math.abs(value - before), digits);
  if (Number(by) === 0) return nothing;
  const up = value > before;
  const said = withUnit(by, unit);
  return html` <small
    ><span aria-hidden="true">${up ? "+" : "−"}${by}</span
    ><span class="out-of-sight">, ${up ? words.up(said) : words.down(said)}</span></small
  >`;
}
