/**
 * The scripts that a worker loads, when they do not come: which of them, and why. Imports nothing of
 * ours.
 */

/** The scripts of an interpreter can't be had; the message says which and why. */
export class NotLoaded extends Error {
  override readonly name = "NotLoaded";
}

/** Whether an interpreter's failure is about scripts that did not come, or came as something else. */
export function isOfLoading(error: unknown): boolean {
  return /import|loaded|fetch|SyntaxError|MIME/i.test(String(error));
}

/**
 * Asks for scripts past every cache, so that damaged copies give way to what the server has now.
 * Resolves to what is wrong with the first that can't be had, or null.
 */
export async function refresh(addresses: readonly string[]): Promise<string | null> {
  const wrongs = await Promise.all(addresses.map(wrongWith));
  return wrongs.find((wrong) => wrong !== null) ?? null;
}

async function wrongWith(address: string): Promise<string | null> {
  const name = new URL(address).pathname.split("/").at(-1);
  try {
    const response = await fetch(address, { cache: "reload" });
    await response.arrayBuffer();
    if (!response.ok) return `${name} could not be fetched: status ${response.status}`;
    const type = response.headers.get("Content-Type") ?? "";
    if (/^(text|application)\/(x-)?(java|ecma)script/.test(type)) return null;
    return `the server sends ${name} as ${type || "nothing it names"}, not as text/javascript`;
  } catch {
    return `${name} could not be fetched: is the network there?`;
  }
}
