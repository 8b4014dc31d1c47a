/**
 * A lab on paper. The editor holds only the lines in sight, so the whole program is written out
 * below the lab while it is printed, and above it which world and noise this was.
 * `lab-print.css` does the rest. Imports nothing of ours.
 */

export interface Sheet {
  heading: string;
  program: string;
}

/** `sheet` is asked when it comes to printing. Returns the function that ends it. */
export function fitForPaper(lab: HTMLElement, sheet: () => Sheet | undefined): () => void {
  const heading = document.createElement("h2");
  const program = document.createElement("pre");
  heading.className = "lab-sheet-heading";
  program.className = "lab-sheet-program";
  const write = (): void => {
    const now = sheet();
    if (!now) return;
    heading.textContent = now.heading;
    // A line each, so that a break between pages never cuts one, and the numbers can be counted.
    const lines = now.program.replace(/\n$/, "").split("\n");
    program.replaceChildren(
      ...lines.map((text) => {
        const line = document.createElement("code");
        line.textContent = `${text}\n`;
        return line;
      }),
    );
    const frame = lab.querySelector(".lab");
    frame?.prepend(heading);
    frame?.append(program);
  };
  const clear = (): void => {
    heading.remove();
    program.remove();
  };
  addEventListener("beforeprint", write);
  addEventListener("afterprint", clear);
  return () => {
    removeEventListener("beforeprint", write);
    removeEventListener("afterprint", clear);
  };
}
