/**
 * What stays as it was when a saved file reloads the page: which parts are open, what was asked to be
 * marked, and where the page was scrolled to. Imports nothing of ours.
 */

const NAME = `bugbot-preview:${location.pathname}`;

interface Record {
  open: string[];
  asked: string[];
  y: number;
}

export class Opened {
  readonly open: Set<string>;
  /** Tasks that are marked again by themselves. */
  readonly asked: Set<string>;
  readonly #y: number;

  constructor() {
    const { open, asked, y } = read();
    this.open = new Set(open);
    this.asked = new Set(asked);
    this.#y = y;
    addEventListener("pagehide", () => this.keep());
  }

  set(part: string, open: boolean): void {
    if (open) this.open.add(part);
    else this.open.delete(part);
  }

  keep(): void {
    const record: Record = { open: [...this.open], asked: [...this.asked], y: scrollY };
    sessionStorage.setItem(NAME, JSON.stringify(record));
  }

  /** Scrolls to where the page was, if nobody has named a place. */
  scroll(): void {
    if (!location.hash && this.#y > 0) scrollTo({ top: this.#y, behavior: "instant" });
  }
}

function read(): Record {
  const none = { open: [], asked: [], y: 0 };
  try {
    return { ...none, ...JSON.parse(sessionStorage.getItem(NAME) ?? "{}") };
  } catch {
    return none;
  }
}
