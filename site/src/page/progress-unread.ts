/**
 * Tells of progress on this device that can't be read, on the pages that show progress: it is kept, and
 * can be saved as a file. May import `ui`.
 */
import { html, render } from "lit";
import { progressWords as words } from "../ui/progress-words.ts";
import type { Progress } from "./progress.ts";
import { saveFile } from "./text-file.ts";

/** It comes at the end of a page's head, or after the tools for progress. */
export function showUnread(element: HTMLElement, progress: Progress): void {
  const place = document.createElement("div");
  if (element.localName === "header") element.append(place);
  else element.after(place);
  const draw = (): void => {
    const notices = progress.unread.map(
      ({ why, text }) => html`<div class="notice" role="status">
        <p>${words.unread[why]}</p>
        <button type="button" class="link" @click=${() => saveFile(words.unreadFile, text)}>
          ${words.saveUnread}
        </button>
        ${
          why === "damaged"
            ? html`<button type="button" class="link" @click=${() => progress.forgetAsides()}>
                ${words.forgetUnread}
              </button>`
            : ""
        }
      </div>`,
    );
    render(notices, place);
  };
  progress.addEventListener("change", draw);
  draw();
}
