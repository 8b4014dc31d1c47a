/** The network, by every protocol and module of Python's library. */

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const NETWORK = {
  kind: "network",
  ways: [
    {
      name: "urllib",
      program: `import urllib.request\nprint("OPEN", urllib.request.urlopen("http://127.0.0.1:4174/").read())`,
    },
    {
      name: "a socket",
      program: `
import socket
s = socket.create_connection(("127.0.0.1", 4174), timeout=2)
s.sendall(b"GET / HTTP/1.0\\r\\n\\r\\n")
data = s.recv(10)
if data:
    print("OPEN", data)`,
    },
    {
      name: "http.client",
      program: `
import http.client
c = http.client.HTTPConnection("127.0.0.1", 4174, timeout=2)
c.request("GET", "/")
print("OPEN", c.getresponse().status)`,
    },
    {
      name: "every protocol of the library",
      program: `
import ftplib, http.client, imaplib, poplib, smtplib, socket, urllib.request, xmlrpc.client
attempts = {
    "ftp": lambda: ftplib.FTP("127.0.0.1", timeout=1),
    "http": lambda: http.client.HTTPConnection("127.0.0.1", 4174, timeout=1).request("GET", "/"),
    "imap": lambda: imaplib.IMAP4("127.0.0.1", timeout=1),
    "pop": lambda: poplib.POP3("127.0.0.1", timeout=1),
    "smtp": lambda: smtplib.SMTP("127.0.0.1", 4174, timeout=1),
    "xmlrpc": lambda: xmlrpc.client.ServerProxy("http://127.0.0.1:4174/").x(),
    "data": lambda: urllib.request.urlopen("http://127.0.0.1:4174/", timeout=1),
}
for name, attempt in attempts.items():
    try:
        attempt()
        print("OPEN", name)
    except BaseException as error:
        print("closed", name, type(error).__name__)`,
    },
    {
      name: "listening, datagrams, and sockets of the machine",
      program: `
import socket
for family, kind, address in ((socket.AF_INET, socket.SOCK_STREAM, ("127.0.0.1", 4999)), (socket.AF_INET, socket.SOCK_DGRAM, ("127.0.0.1", 4998)), (getattr(socket, "AF_UNIX", 1), socket.SOCK_STREAM, "/tmp/s")):
    try:
        s = socket.socket(family, kind)
        s.bind(address)
        s.listen()
        s.settimeout(0.1)
        s.accept()
        print("OPEN")
    except BaseException as error:
        print("closed", type(error).__name__)
try:
    s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    s.sendto(b"secret", ("127.0.0.1", 4174))
    answer = s.recv(10)
    if answer: print("OPEN", answer)
except BaseException as error:
    print("closed", type(error).__name__)`,
    },
    {
      name: "asyncio's connections",
      program: `
import asyncio
async def main():
    reader, writer = await asyncio.wait_for(asyncio.open_connection("127.0.0.1", 4174), 1)
    writer.write(b"GET /secret HTTP/1.0\\r\\n\\r\\n")
    print("OPEN", await reader.read(10))
asyncio.run(main())`,
    },
    {
      name: "names looked up, which is a message too",
      program: `
import socket
for attempt in (lambda: socket.getaddrinfo("secret.example.test", 80), lambda: socket.gethostbyname("secret.example.test")):
    try:
        print("closed: made up", attempt())
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
  ],
};

/** @type {Kind} */
export const PYTHONS_LIBRARY = {
  kind: "Python's library",
  ways: [
    {
      name: "another address named in XML",
      program: `
import io, xml.sax, xml.sax.handler
from xml.dom import pulldom
text = '<!DOCTYPE a [<!ENTITY e SYSTEM "http://127.0.0.1:4174/secret">]><a>&e;</a>'
parser = xml.sax.make_parser()
parser.setFeature(xml.sax.handler.feature_external_ges, True)
try:
    parser.parse(io.StringIO(text))
    print("closed")
except BaseException as error:
    print("closed", type(error).__name__)`,
    },
    {
      name: "logging that sends, and listens",
      program: `
import logging, logging.config, logging.handlers
for make in (lambda: logging.handlers.HTTPHandler("127.0.0.1:4174", "/"), lambda: logging.handlers.SocketHandler("127.0.0.1", 4174), lambda: logging.handlers.SysLogHandler(("127.0.0.1", 4174)), lambda: logging.handlers.DatagramHandler("127.0.0.1", 4174)):
    try:
        make().emit(logging.makeLogRecord({"msg": "secret"}))
        print("sent nowhere")
    except BaseException as error:
        print("closed", type(error).__name__)
try:
    logging.config.listen(4999).start()
    print("OPEN")
except BaseException as error:
    print("closed", type(error).__name__)`,
    },
    {
      name: "sqlite's extensions, and files it opens itself",
      program: `
import sqlite3
one = sqlite3.connect(":memory:")
for attempt in (lambda: one.enable_load_extension(True), lambda: one.load_extension("/tmp/evil.so"), lambda: one.execute("select load_extension('/tmp/evil.so')").fetchall(), lambda: one.execute("attach '/proc/self/mem' as m").execute("select * from m.x").fetchall(), lambda: one.execute("select readfile('/etc/passwd')").fetchall()):
    try:
        if attempt(): print("OPEN")
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "servers, browsers and terminals of the library",
      program: `
import importlib
def started(work):
    try:
        work()
        print("OPEN", work)
    except BaseException as error:
        print("closed", type(error).__name__)
started(lambda: importlib.import_module("http.server").HTTPServer(("", 4999), None).handle_request())
started(lambda: importlib.import_module("ensurepip").bootstrap())
started(lambda: importlib.import_module("pty").spawn("/bin/sh"))
started(lambda: importlib.import_module("venv").create("/tmp/v", with_pip=True))
started(lambda: importlib.import_module("tkinter").Tk())`,
    },
    {
      name: "timers left behind",
      program: `
import asyncio, faulthandler, sched, threading
for later in (lambda: threading.Timer(0.01, print, ("OPEN",)).start(), lambda: faulthandler.dump_traceback_later(0.01), lambda: asyncio.get_event_loop().call_later(0.01, print, "OPEN"), lambda: asyncio.new_event_loop().call_soon(print, "OPEN"), lambda: asyncio.ensure_future(asyncio.sleep(0))):
    try:
        later()
        print("set")
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
  ],
};
