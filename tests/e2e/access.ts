/** What axe knows of WCAG 2.2 AA, asked of the page as it stands, in both themes. */
import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { expect } from "./fixtures.ts";

const WCAG = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

/** A screen that is narrower is a phone's. */
const PHONE_PX = 600;

/**
 * The page breaks no rule. Between the themes only the colours differ, so only they are looked at a
 * second time; on a phone, where they are the same again, they are not looked at. `without` names parts that another story
 * looks at.
 */
export async function expectAccess(page: Page, without: readonly string[] = []): Promise<void> {
  const violations = async (choose: (look: AxeBuilder) => AxeBuilder): Promise<string[]> => {
    // In the page itself, whose one frame is hidden, and only what is wrong: a quarter of the time.
    const plain = new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ["violations"] });
    const look = choose(plain).exclude("iframe");
    for (const part of without) look.exclude(part);
    return (await look.analyze()).violations.flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id} at ${target.join(" ")}: ${failureSummary}`),
    );
  };
  if ((page.viewportSize()?.width ?? 0) < PHONE_PX) {
    const rest = (look: AxeBuilder) => look.withTags(WCAG).disableRules(["color-contrast"]);
    expect(await violations(rest)).toEqual([]);
    return;
  }
  await page.emulateMedia({ colorScheme: "light" });
  expect(await violations((look) => look.withTags(WCAG))).toEqual([]);
  await page.emulateMedia({ colorScheme: "dark" });
  const colours = await violations((look) => look.withRules(["color-contrast"]));
  expect(colours, "in the dark").toEqual([]);
}
