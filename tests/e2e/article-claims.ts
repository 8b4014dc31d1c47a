/**
 * What the article claims, to be held against runs in the browser: the figures that stand in its
 * page, and the checks beside them in its Markdown.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { parseReference } from "../../site/build/lessons/figure-grammar.mjs";
import { figureValue, holds } from "../../site/build/lessons/figure-value.mjs";
import type { Outcome } from "../../site/src/trace/events.ts";

type Constants = Readonly<Record<string, number>>;

/** A figure of the page: what it says it is, its exact value, and as it is written. */
interface Shown {
  of: string;
  value: number;
  text: string;
}

/** Every figure that stands in the page. */
export function figuresOf(page: Page): Promise<Shown[]> {
  return page.locator("data[data-of]").evaluateAll((elements) =>
    elements.map((element) => ({
      of: element.getAttribute("data-of") ?? "",
      value: Number(element.getAttribute("value")),
      text: element.textContent ?? "",
    })),
  );
}

/** The checks of the article's Markdown. */
function checks() {
  const markdown = readFileSync(join(ROOT, "lessons/occupancy-grid-mapping/lesson.md"), "utf8");
  return [...markdown.matchAll(/\{\{\s*(check .*?)\s*\}\}/g)].flatMap(([, text = ""]) => {
    const reference = parseReference(text);
    return reference.kind === "check" ? [reference] : [];
  });
}

type Figure = ReturnType<typeof checks>[number]["left"];

/** Runs of the browser by program and constants, with the world and the noise of the page. */
export class Runs {
  readonly #outcomes = new Map<string, Outcome>();

  add(program: string, constants: Constants, outcome: Outcome): void {
    this.#outcomes.set(keyOf(program, constants), outcome);
  }

  /** Null for a figure of another run, or of many. */
  valueOf(figure: Figure): number | null {
    if (figure.seeds) return null;
    const { constants } = figure;
    const numbers = Object.entries(constants).map(([name, text]) => [name, Number(text)]);
    const outcome = this.#outcomes.get(keyOf(figure.program, Object.fromEntries(numbers)));
    return outcome ? figureValue(figure, [outcome]) : null;
  }

  /** The figures that these runs give, each with the value that came out. */
  measured(shown: readonly Shown[]): (Shown & { measured: number })[] {
    return shown.flatMap((each) => {
      const reference = parseReference(each.of);
      const measured = reference.kind === "figure" ? this.valueOf(reference.figure) : null;
      return measured === null ? [] : [{ ...each, measured }];
    });
  }

  /** The checks that these runs decide: which hold, and which do not. */
  checked(): { held: string[]; broken: string[] } {
    const result = { held: [] as string[], broken: [] as string[] };
    for (const check of checks()) {
      const left = this.valueOf(check.left);
      const right = typeof check.right === "number" ? check.right : this.valueOf(check.right);
      if (left === null || right === null) continue;
      result[holds(check, left, right) ? "held" : "broken"].push(check.text);
    }
    return result;
  }
}

function keyOf(program: string, constants: Constants): string {
  const settings = Object.entries(constants).map(([name, value]) => `${name}=${value}`);
  return [program, ...settings.sort()].join(" ");
}

/** Whether a number in prose ("−62.9", "901") is another one, rounded as it is written. */
export function isRounded(text: string, value: number): boolean {
  const decimals = text.split(".")[1]?.length ?? 0;
  return Math.abs(Number(text.replace("−", "-")) - value) <= 0.5 * 10 ** -decimals + 1e-9;
}
