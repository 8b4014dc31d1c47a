/**
 * The panel that lists what can be done by keyboard. May import `ui`.
 */
import { html } from "lit";
import { Dialog } from "../ui/dialog.ts";
import { keyWords } from "../ui/key-words.ts";
import "./keys-dialog.css";

export function showKeys(): void {
  const dialog = new Dialog<never>(keyWords.title);
  dialog.element.classList.add("narrow");
  dialog.show(
    html`<div class="panel-keys" tabindex="0" role="region" aria-label=${keyWords.title}>
      ${keyWords.groups.map(
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
