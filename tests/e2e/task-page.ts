/**
 * A task as a person finds it: by role and label.
 */
import type { Locator, Page } from "@playwright/test";

interface Lab extends HTMLElement {
  program: string;
}

export class Task {
  readonly page: Page;
  readonly root: Locator;
  readonly check: Locator;
  readonly cancel: Locator;
  readonly mark: Locator;
  readonly checks: Locator;
  readonly run: Locator;
  readonly program: Locator;
  readonly runStatus: Locator;

  /** The task of a title. */
  constructor(page: Page, title: string) {
    this.page = page;
    this.root = page.getByRole("article", { name: title, exact: true });
    this.check = this.button("Check my work");
    this.cancel = this.button("Cancel");
    this.mark = this.root.getByRole("status", { name: "Mark" });
    this.checks = this.root.getByRole("list", { name: "Checks" }).getByRole("listitem");
    this.run = this.button("Run");
    this.program = this.root.getByRole("textbox", { name: "Program" });
    this.runStatus = this.root.getByRole("status", { name: "Status of the run" });
  }

  button(name: string): Locator {
    return this.root.getByRole("button", { name, exact: true });
  }

  /** Puts a program into the editor, as a page does. */
  async write(program: string): Promise<void> {
    await this.root.locator("bugbot-lab").evaluate((lab: Lab, text) => {
      lab.program = text;
    }, program);
  }

  /** The whole program; the screen holds only the lines in sight. */
  text(): Promise<string> {
    return this.root.locator("bugbot-lab").evaluate((lab: Lab) => lab.program);
  }

  /** Marks a program and waits for its mark. */
  async marked(program: string): Promise<void> {
    await this.write(program);
    // A mark may come sooner than one can look for the Cancel that goes with it.
    const marked = this.root.evaluate(
      (task) =>
        new Promise<void>((resolve) => {
          let begun = false;
          new MutationObserver((_, observer) => {
            const buttons = [...task.querySelectorAll("button")];
            const marking = buttons.some((button) => button.textContent?.trim() === "Cancel");
            if (begun && !marking) {
              observer.disconnect();
              resolve();
            }
            begun ||= marking;
          }).observe(task, { childList: true, subtree: true });
        }),
    );
    await this.check.click();
    await marked;
  }
}
