/**
 * Use without a network, as far as every page carries it: when to keep the site on this device, the
 * button in the footer, and the note that there is a new version. What is behind them is fetched
 * when it is wanted. May import `ui`.
 */
import { html, render } from "lit";
import { recall } from "../ui/dom.ts";
import { offlineWords as words } from "../ui/offline-words.ts";
import { part } from "../ui/part.ts";
import { savesData, whenIdle } from "./when-wanted.ts";

/** A reader who stays so long after Python is up stays; what they came for came first. [ms] */
const SETTLED_MS = 8000;

export function showOffline(root: string): void {
  const place = document.querySelector<HTMLElement>(".site-footer .offline");
  if (place) {
    const open = async (): Promise<void> =>
      (await part(() => import("./offline-dialog.ts"))).showDialog(root);
    render(html`<button type="button" class="link" @click=${open}>${words.open}</button>`, place);
  }
  whenIdle(() => void watch(root));
}

/**
 * Keeps the site on this device once the page has what it needs itself and has been quiet for a
 * while: not where data is to be saved, and not where the reader has removed it.
 */
export function keepSoon(root: string): void {
  if (savesData() || recall("offline") === "no") return;
  setTimeout(() => whenIdle(() => void keepNow(root)), SETTLED_MS);
}

async function keepNow(root: string): Promise<void> {
  // Nobody has asked for it, so nobody is told of a failure; the next visit tries again.
  try {
    const { keep, obstacle } = await import("./offline-keeper.ts");
    if (obstacle() !== null || recall("offline") === "no") return;
    await keep(root);
    await watch(root);
  } catch (error) {
    console.info("Not kept for offline use:", error);
  }
}

/** Pages that come from this device tell when there is something newer. */
export async function watch(root: string): Promise<void> {
  const registration = await navigator.serviceWorker?.getRegistration(root);
  if (!registration) return;
  const { tellOfNewVersions } = await part(() => import("./new-version.ts"));
  tellOfNewVersions(registration);
}
