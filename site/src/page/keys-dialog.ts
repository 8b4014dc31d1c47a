/**
 * The panel that lists what can be done by keyboard. May import `ui`.
 */
import { html } from "lit";
import { Dialog } from "../ui/dialog.ts";
import { keyWords } from "../ui/key-words.ts";
import "./keys-dialog.css";

interface KeyList {
  title: string;
  groups: readonly { title: string; keys: readonly (readonly string[])[] }[];
}

/** The keys of the lab. */
export function showKeys(): void {
  showKeyList(keyWords);
}

export function showKeyList({ title: heading, groups }: KeyList): void {
  const dialog = new Dialog<never>(heading);
  dialog.element.classList.add("narrow");
  dialog.show(
    html`<div class="panel-keys" tabindex="0" role="region" aria-label=${heading}>
      ${groups.map(
        ({ title, keys }) => html`<h3>${title}</h3>
          <dl>
            ${keys.map(
              ([key, does]) => html`<div>
                <dt>${key}</dt>
                <dd>${does}</dd>
              </div>`,
            )}
          </dl>`,
      )}
    </div>`,
  );
}
