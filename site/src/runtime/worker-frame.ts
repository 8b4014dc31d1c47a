/**
 * Where the page's workers are made: a hidden frame whose policy allows scripts and nothing else.
 *
 * A worker whose script is a `blob:` inherits the Content-Security-Policy of the document that made
 * it, in every engine; one that is started from a URL would have none on a host that can't send headers.
 * The page itself may fetch, and show fonts and images, from its own server. A worker needs none of that:
 * the page hands it everything but its scripts. Imports nothing of ours.
 */
import frameAddress from "./worker-frame.html?url";

/** What the workers of a document are made with. */
type Maker = Pick<typeof globalThis, "Blob" | "URL" | "Worker">;

/** The frame comes with the first scripts; if it takes longer than this, the page does without [ms]. */
const PATIENCE_MS = 5000;

let maker: Promise<Maker> | null = null;

/**
 * The frame's window. It is the page's own if the frame can't be had (some hosts let nothing be framed):
 * a program is then kept in by the lock-down and by the page's policy, which still lets nothing out of the site.
 */
function makerOfWorkers(): Promise<Maker> {
  maker ??= new Promise((resolve) => {
    const frame = document.createElement("iframe");
    frame.hidden = true;
    frame.src = new URL(frameAddress, import.meta.url).href;
    const settle = () =>
      resolve(hasPolicy(frame) ? (frame.contentWindow as Window & Maker) : window);
    frame.addEventListener("load", settle);
    setTimeout(settle, PATIENCE_MS);
    document.body.append(frame);
  });
  return maker;
}

/** Whether it shows our document, and not a host's or a browser's page about something missing. */
function hasPolicy({ contentDocument }: HTMLIFrameElement): boolean {
  return contentDocument?.querySelector("meta[http-equiv=Content-Security-Policy]") != null;
}

/**
 * A module worker that imports the script at this address.
 *
 * The script is had by import(): without a network Firefox asks the service worker for those, not for
 * what a blob's `import` names. A message that comes before the script is held for it.
 */
export async function startWorker(address: string): Promise<Worker> {
  const script = `
    let early = null;
    self.onmessage = (event) => { early = event; };
    import(${JSON.stringify(address)}).then(
      () => { const held = early; early = null; if (held) self.onmessage(held); },
      (error) => setTimeout(() => { throw error; }),
    );`;
  const { Blob, URL, Worker } = await makerOfWorkers();
  const blobUrl = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const worker = new Worker(blobUrl, { type: "module", name: "Python" });
  // The worker has taken its script by the time it says anything, and no later.
  setTimeout(() => URL.revokeObjectURL(blobUrl), 60_000);
  return worker;
}
