/**
 * The panel that gives a link to a program, or to a mat. May import `ui`.
 */
import { html, nothing } from "lit";
import { Dialog } from "../ui/dialog.ts";
import { shareWords } from "../ui/file-words.ts";
import { LONG_LINK } from "./share.ts";
import "./share-dialog.css";

/** Shows a link to copy; `onSave` saves what it holds as a file instead. */
export function showLink(
  link: string,
  onSave: () => void,
  words: { title: string; lead: string; save: string } = shareWords,
): void {
  const dialog = new Dialog<never>(words.title);
  dialog.element.classList.add("narrow");
  const draw = (said: string): void => {
    dialog.show(
      html`<p>${words.lead}</p>
        ${
          link.length > LONG_LINK
            ? html`<p class="panel-note">${shareWords.long(link.length)}</p>`
            : nothing
        }
        <input
          class="share-link"
          type="text"
          readonly
          aria-label=${shareWords.link}
          .value=${link}
          @focus=${(event: Event) => (event.target as HTMLInputElement).select()}
        />
        <footer>
          <p role="status">${said}</p>
          <button type="button" @click=${onSave}>${words.save}</button>
          <button type="button" class="go" autofocus @click=${copy}>${shareWords.copy}</button>
        </footer>`,
    );
  };
  const copy = async (): Promise<void> => {
    try {
      await navigator.clipboard.writeText(link);
      draw(shareWords.copied);
    } catch {
      // No leave, or a page that is not served securely.
      draw(shareWords.notCopied);
      dialog.part(".share-link").focus();
    }
  };
  draw("");
}
