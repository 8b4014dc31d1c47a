/**
 * <lab-menu>: one quiet button, and behind it everything that is not needed every minute.
 *
 * A disclosure, not a menu in the sense of ARIA: the list holds plain buttons, which Tab goes
 * through; the arrow keys, Home and End go from one to the next as well. Esc closes it.
 * Set `groups`, and `prepare` if they have to be fetched before the list opens. May import `ui`.
 */
import { html, LitElement, type TemplateResult } from "lit";
import { icons } from "../ui/icons.ts";
import { labWords } from "../ui/strings.ts";
import "./lab-menu.css";

export interface MenuItem {
  label: string;
  disabled?: boolean;
  act(): void;
}

export interface MenuGroup {
  title: string;
  items: readonly MenuItem[];
}

let menus = 0;

export class LabMenu extends LitElement {
  static override properties = {
    groups: { attribute: false },
    prepare: { attribute: false },
    open: { state: true },
  };
  declare groups: readonly MenuGroup[];
  declare prepare: () => Promise<void>;
  declare open: boolean;
  readonly #id = `menu-${++menus}`;
  /** It has been asked for and its groups are on their way. */
  #isComing = false;

  constructor() {
    super();
    this.groups = [];
    this.prepare = async () => {};
    this.open = false;
    this.addEventListener("keydown", (event) => this.#onKey(event));
    this.addEventListener("focusout", ({ relatedTarget }) => {
      // Null when the window is left, or a finger presses what takes no focus.
      if (relatedTarget instanceof Node && !this.contains(relatedTarget)) this.#leave();
    });
  }

  readonly #onPress = ({ target }: Event): void => {
    if (!(target instanceof Node && this.contains(target))) this.#leave();
  };

  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    document.addEventListener("pointerdown", this.#onPress);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    document.removeEventListener("pointerdown", this.#onPress);
  }

  override render(): TemplateResult {
    return html`<button
        type="button"
        class="lab-menu-button"
        aria-expanded=${this.open ? "true" : "false"}
        aria-controls=${this.#id}
        @click=${() => {
          if (this.open) this.open = false;
          else void this.#open();
        }}
      >
        ${icons.more}<span>${labWords.more}</span>
      </button>
      <div class="lab-menu-panel" id=${this.#id} ?hidden=${!this.open}>
        ${this.groups.map(({ title, items }, i) => this.#group(`${this.#id}-${i}`, title, items))}
      </div>`;
  }

  #group(id: string, title: string, items: readonly MenuItem[]): TemplateResult {
    return html`<p id=${id}>${title}</p>
      <ul aria-labelledby=${id}>
        ${items.map(
          (item) => html`<li>
            <button type="button" ?disabled=${item.disabled} @click=${() => this.#act(item)}>
              ${item.label}
            </button>
          </li>`,
        )}
      </ul>`;
  }

  async #open(): Promise<void> {
    this.#isComing = true;
    if (this.groups.length === 0) await this.prepare();
    // Whoever has gone elsewhere meanwhile is not interrupted there.
    if (this.#isComing) this.open = true;
    this.#isComing = false;
  }

  #leave(): void {
    this.#isComing = false;
    this.open = false;
  }

  #act(item: MenuItem): void {
    this.#close();
    item.act();
  }

  #close(): void {
    this.open = false;
    this.querySelector<HTMLElement>(".lab-menu-button")?.focus();
  }

  #onKey(event: KeyboardEvent): void {
    const enabled = [...this.querySelectorAll<HTMLElement>("button:enabled")];
    const [button, ...items] = enabled;
    const at = items.indexOf(document.activeElement as HTMLElement);
    const moves: Record<string, HTMLElement | undefined> = {
      ArrowDown: items[at + 1] ?? items.at(-1),
      ArrowUp: items[at - 1] ?? button,
      Home: items[0],
      End: items.at(-1),
    };
    if (event.key === "Escape" && this.open) this.#close();
    else if (event.key === "ArrowDown" && !this.open) void this.#open();
    else if (this.open && moves[event.key]) moves[event.key]?.focus();
    else return;
    event.preventDefault();
  }
}

customElements.define("lab-menu", LabMenu);
