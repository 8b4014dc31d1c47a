/**
 * Where the page's workers are made: a hidden frame whose policy allows scripts and nothing else.
 *
 * A worker whose script is a `blob:` inherits the Content-Security-Policy of the document that made
 * it, in every engine. The page itself may fetch, and show fonts and images, from its own server;
 * a worker needs none of that, as the page hands it everything but its scripts. Imports nothing of ours.
 */

/** A worker's scripts come from the site; it fetches, loads and shows nothing else, not even from there. */
function policy(origin: string): string {
  return [
    "default-src 'none'",
    `script-src ${origin} blob: 'wasm-unsafe-eval'`,
    `worker-src ${origin} blob:`,
  ].join("; ");
}

type Scope = Window & Pick<typeof globalThis, "Blob" | "URL" | "Worker">;

let frame: Promise<Scope> | null = null;

/** The frame's window; made at the first call. */
function scope(): Promise<Scope> {
  frame ??= new Promise((resolve, reject) => {
    const element = document.createElement("iframe");
    element.hidden = true;
    element.title = "Python's workers";
    element.srcdoc = `<!doctype html><meta http-equiv="Content-Security-Policy" content="${policy(location.origin)}">`;
    element.addEventListener("load", () => {
      if (element.contentWindow) resolve(element.contentWindow as Scope);
      else reject(new Error("The frame for Python's workers could not be made"));
    });
    document.body.append(element);
  });
  return frame;
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
  const { Blob, URL, Worker } = await scope();
  const blobUrl = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const worker = new Worker(blobUrl, { type: "module", name: "Python" });
  // The worker has taken its script by the time it says anything, and no later.
  setTimeout(() => URL.revokeObjectURL(blobUrl), 60_000);
  return worker;
}
