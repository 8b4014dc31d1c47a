import { loadPyodide } from "./pyodide/pyodide.mjs";

self.onmessage = async ({ data }) => {
  let sent = false;
  const pyodide = await loadPyodide({
    stdout: (text) => {
      if (!sent) self.postMessage({ text });
      sent = true;
    },
  });
  pyodide.runPython(data);
};
