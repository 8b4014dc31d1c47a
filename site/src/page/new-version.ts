/**
 * A quiet note that a new version of the site is ready. The page goes on with the version it has,
 * until the reader says so. May import `ui`.
 */
import { html, render } from "lit";
import { offlineWords as words } from "../ui/offline-words.ts";
import "./new-version.css";
import { takeOver } from "./offline-keeper.ts";

/** Who has said "later" is not asked again on the next page of this visit. */
const LATER = "bugbot:new-version-later";

export function tellOfNewVersions(registration: ServiceWorkerRegistration): void {
  const tell = (): void => {
    // Without an active worker it is no new version but the first.
    if (registration.waiting && registration.active) show(registration.waiting);
  };
  tell();
  registration.addEventListener("updatefound", () => {
    registration.installing?.addEventListener("statechange", tell);
  });
}

function show(waiting: ServiceWorker): void {
  if (putOff() || document.querySelector(".new-version")) return;
  const note = document.createElement("div");
  note.className = "new-version";
  const say = (said: boolean): void => {
    const later = (): void => {
      putOff(true);
      note.remove();
    };
    render(
      html`<p role="status">${said ? words.newVersion : ""}</p>
        <button type="button" class="go" @click=${() => takeOver(waiting)}>${words.useNow}</button>
        <button type="button" @click=${later}>${words.later}</button>`,
      note,
    );
  };
  // A status is read out when it changes, not when it comes.
  say(false);
  document.body.append(note);
  requestAnimationFrame(() => say(true));
}

/** Whether the reader has said "later" in this tab; `true` says so. */
function putOff(now = false): boolean {
  try {
    if (now) sessionStorage.setItem(LATER, "yes");
    return sessionStorage.getItem(LATER) !== null;
  } catch {
    // Storage is refused: the next page asks again.
    return now;
  }
}
