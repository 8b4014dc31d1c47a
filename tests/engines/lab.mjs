/** A lab in a page, found by role and label. */

/**
 * @typedef {import("./tab.mjs").Tab} Tab
 * @typedef {import("./look.mjs").Where} Where
 */

export class Lab {
  /** @type {Tab} */
  tab;
  #within;

  /**
   * @param {Tab} tab
   * @param {Where} [within] what the lab lies in, on a page of several
   */
  constructor(tab, within) {
    this.tab = tab;
    this.#within = within;
  }

  /**
   * A thing of this lab.
   * @param {string} role
   * @param {string} name
   * @returns {Where}
   */
  its(role, name) {
    return { role, name, ...(this.#within ? { within: this.#within } : {}) };
  }

  /** @param {string} query */
  async open(query) {
    await this.tab.open(`lab/?${query}`);
    await this.tab.see(this.its("textbox", "Program"));
  }

  /** @param {RegExp} wanted */
  status(wanted) {
    return this.tab.see(this.its("status", "Status of the run"), wanted);
  }

  /** @param {RegExp} wanted */
  printed(wanted) {
    return this.tab.see(this.its("log", "Console"), wanted);
  }

  /**
   * Types over the program in the editor, with the keys of a keyboard.
   * @param {string} line one line: after Enter the editor indents by itself
   */
  async type(line) {
    await this.tab.focus(this.its("textbox", "Program"));
    await this.tab.press("SelectAll");
    await this.tab.type(line);
    const text = await this.text();
    if (text !== line) throw new Error(`typed “${line}”, the editor has “${text.slice(0, 80)}”`);
  }

  /**
   * Puts a program into the editor, as a page does.
   * @param {string} program
   */
  async write(program) {
    const editor = this.its("textbox", "Program");
    await this.tab.see(editor);
    await this.tab.evaluateOn(
      editor,
      (element, /** @type {string} */ text) => {
        /** @type {(HTMLElement & { program: string }) | null} */
        const lab = element.closest("bugbot-lab");
        if (lab) lab.program = text;
      },
      program,
    );
  }

  /** The program; the screen holds only the lines in sight. */
  async text() {
    const text = await this.tab.evaluateOn(this.its("textbox", "Program"), (element) => {
      /** @type {(HTMLElement & { program: string }) | null} */
      const lab = element.closest("bugbot-lab");
      return lab?.program ?? null;
    });
    return text ?? "";
  }

  /** The run on show, as the text of a trace file. */
  async trace() {
    const text = await this.tab.evaluateOn(this.its("textbox", "Program"), (element) => {
      /** @type {(HTMLElement & { traceText(): Promise<string | null> }) | null} */
      const lab = element.closest("bugbot-lab");
      return lab?.traceText() ?? null;
    });
    return text ?? "";
  }

  /**
   * Runs a program as a page does that embeds a lab; what it has printed.
   * @param {string} program
   */
  async outcome(program) {
    const printed = await this.tab.evaluateOn(
      this.its("textbox", "Program"),
      async (element, /** @type {string} */ text) => {
        /** @type {(HTMLElement & { program: string, run(): Promise<{ console: string }> }) | null} */
        const lab = element.closest("bugbot-lab");
        if (!lab) return null;
        lab.program = text;
        return (await lab.run()).console;
      },
      program,
    );
    return printed ?? "";
  }

  async run() {
    await this.tab.click(this.its("button", "Run"));
  }

  async stop() {
    await this.tab.click(this.its("button", "Stop"));
  }
}
