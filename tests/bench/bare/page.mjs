/** Starts Pyodide in a worker as its documentation shows, and notes when the first output is there. */
const worker = new Worker(new URL("worker.mjs", import.meta.url), { type: "module" });
worker.onmessage = ({ data }) => {
  Object.assign(window, { firstOutput: { ms: performance.now(), ...data } });
};
worker.postMessage('print("hello")');
