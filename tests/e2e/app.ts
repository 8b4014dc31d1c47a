/**
 * The site as a person finds it: by role and label. The stories use nothing else.
 */
import { readFile } from "node:fs/promises";
import { expect, type Locator, type Page } from "@playwright/test";

export class App {
  readonly page: Page;
  readonly run: Locator;
  readonly stop: Locator;
  readonly reset: Locator;
  readonly status: Locator;
  readonly program: Locator;
  readonly console: Locator;
  readonly view: Locator;
  readonly time: Locator;
  readonly speed: Locator;
  readonly step: Locator;
  readonly stepBack: Locator;
  readonly play: Locator;
  readonly pause: Locator;
  readonly world: Locator;
  readonly seed: Locator;
  readonly problem: Locator;

  constructor(page: Page) {
    this.page = page;
    const button = (name: string): Locator => page.getByRole("button", { name, exact: true });
    this.run = button("Run");
    this.stop = button("Stop");
    this.reset = button("Reset program");
    this.step = button("Step");
    this.stepBack = button("Step back");
    this.play = button("Play");
    this.pause = button("Pause");
    this.status = page.getByRole("status", { name: "Status of the run" });
    this.program = page.getByRole("textbox", { name: "Program" });
    this.console = page.getByRole("log", { name: "Console" });
    this.view = page.getByRole("img", { name: "Overhead view" });
    this.time = page.getByRole("slider", { name: "Time" });
    this.speed = page.getByRole("combobox", { name: "Speed" });
    this.world = page.getByRole("combobox", { name: "World" });
    this.seed = page.getByRole("textbox", { name: "Seed" });
    this.problem = page.getByRole("region", { name: "What went wrong" });
  }

  /** Opens the lab; `query` is what follows the question mark. */
  async openLab(query = ""): Promise<void> {
    await this.page.goto(`lab/${query && `?${query}`}`);
    await expect(this.program).toBeVisible();
  }

  /** Writes a program over the one in the editor, as pasting does. */
  async write(program: string): Promise<void> {
    // Not by a click: in the middle of the editor there may be a slider.
    await this.program.focus();
    await this.page.keyboard.press("ControlOrMeta+a");
    if (program === "") await this.page.keyboard.press("Delete");
    else await this.page.keyboard.insertText(program);
    expect(await this.text()).toBe(program);
  }

  /** Puts a program into the lab as a page does: for one too long to be typed. */
  async setProgram(program: string): Promise<void> {
    await this.page
      .locator("bugbot-lab")
      .evaluate((lab: HTMLElement & { program: string }, text) => {
        lab.program = text;
      }, program);
  }

  /** The whole program; the screen holds only the lines in sight. */
  async text(): Promise<string> {
    return this.page
      .locator("bugbot-lab")
      .evaluate((lab: HTMLElement & { program: string }) => lab.program);
  }

  /** Opens the More button and presses one of what is behind it. */
  async more(item: string): Promise<void> {
    await this.page.getByRole("button", { name: "More", exact: true }).click();
    await this.page.getByRole("button", { name: item }).click();
  }

  /** The same for an item that saves a file: its name and what is in it. */
  async saved(item: string): Promise<{ name: string; content: Buffer }> {
    const saving = this.page.waitForEvent("download");
    await this.more(item);
    const download = await saving;
    return { name: download.suggestedFilename(), content: await readFile(await download.path()) };
  }

  /** The same for an item that opens a file. */
  async openFile(item: string, name: string, content: string | Buffer): Promise<void> {
    const choosing = this.page.waitForEvent("filechooser");
    await this.more(item);
    const buffer = Buffer.from(content);
    await (await choosing).setFiles({ name, mimeType: "application/octet-stream", buffer });
  }

  /** Shows the end of a run at once, so that a story need not wait for it to play. */
  async showEndsAtOnce(): Promise<void> {
    await this.speed.selectOption("to the end");
  }

  /** Writes a program, runs it, and waits for the end to be told. */
  async runToEnd(program: string): Promise<void> {
    await this.write(program);
    await this.run.click();
    await this.ended();
  }

  async ended(): Promise<void> {
    // A flood of printing on a busy machine takes its time.
    await expect(this.stop).toBeDisabled({ timeout: 45_000 });
    await expect(this.status).not.toHaveText(/Running|starting|Ready/);
  }
}
