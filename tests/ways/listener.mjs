/** Somebody whom a program would reach, were it let: a port of this machine that tells who came. */
import { once } from "node:events";
import { createServer } from "node:net";

/** Listens on a free port, and counts who connects. */
export async function listen() {
  let came = 0;
  const server = createServer((socket) => {
    came += 1;
    socket.on("error", () => {});
    socket.end("HTTP/1.0 200 OK\r\n\r\nreached");
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  const address = server.address();
  if (typeof address !== "object" || !address) throw new Error("there is no port to listen on");
  return { port: address.port, came: () => came, close: () => server.close() };
}
