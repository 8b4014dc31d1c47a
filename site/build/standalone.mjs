/**
 * One TypeScript file, with what it imports, as one classic script that stands alone: for a service
 * worker, and for what other sites' pages load.
 */
import { build } from "vite";

/**
 * @param {string} entry the file
 * @returns {Promise<string>} the script
 */
export async function standalone(entry) {
  const built = await build({
    configFile: false,
    logLevel: "warn",
    publicDir: false,
    build: {
      write: false,
      target: "es2022",
      rollupOptions: { input: entry, output: { format: "iife", codeSplitting: false } },
    },
  });
  const [result] = [built].flat();
  const chunk = result && "output" in result ? result.output[0] : null;
  if (!chunk) throw new Error(`${entry}: Vite has made nothing of it`);
  return chunk.code;
}
