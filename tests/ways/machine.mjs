/** Processes, devices and files of the machine. */

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const THE_MACHINE = {
  kind: "the machine",
  ways: [
    {
      name: "another process",
      program: `import subprocess\nprint("OPEN", subprocess.run(["ls"], capture_output=True))`,
    },
    {
      name: "os.system, os.fork, os.execv",
      program: `
import os
for attempt in (lambda: os.system("ls") == 0, lambda: os.fork(), lambda: os.execv("/bin/ls", ["ls"])):
    try:
        if attempt():
            print("OPEN")
        else:
            print("closed")
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "a thread",
      program: `import threading\nt = threading.Thread(target=print, args=("OPEN",))\nt.start()`,
    },
    {
      name: "webbrowser",
      program: `import webbrowser\nprint("OPEN" if webbrowser.open("http://127.0.0.1:4174/") else "closed")`,
    },
    {
      name: "processes of every kind",
      program: `
import os, subprocess
attempts = {
    "spawn": lambda: os.posix_spawn("/bin/sh", ["sh"], {}),
    "popen": lambda: os.popen("echo x").read() == "x\\n" or 1 / 0,
    "call": lambda: subprocess.check_output("echo x", shell=True),
    "spawnv": lambda: os.spawnv(os.P_WAIT, "/bin/sh", ["sh"]) == 0 or 1 / 0,
    "forkpty": lambda: os.forkpty(),
}
for name, attempt in attempts.items():
    try:
        attempt()
        print("OPEN", name)
    except BaseException as error:
        print("closed", name, type(error).__name__)`,
    },
    {
      name: "pools of threads and processes",
      program: `
from concurrent.futures import ThreadPoolExecutor
try:
    with ThreadPoolExecutor(1) as pool: print("OPEN", pool.submit(pow, 2, 3).result(timeout=1))
except BaseException as error:
    print("closed", type(error).__name__)
try:
    import multiprocessing
    p = multiprocessing.Process(target=print)
    p.start()
    print("OPEN")
except BaseException as error:
    print("closed", type(error).__name__)`,
    },
    {
      name: "mounting and devices",
      program: `
import os
for attempt in (lambda: os.mknod("/dev/mine", 0o20666, os.makedev(5, 0)), lambda: os.chroot("/tmp"), lambda: os.link("/dev/stdout", "/tmp/out"), lambda: os.open("/proc/1/mem", os.O_RDWR)):
    try:
        print("closed: no more than a file in memory", attempt())
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "a file left for the next run",
      program: `
import os
for path in ("/lib/python3.14/site-packages/sitecustomize.py", "/lib/python3.14/site-packages/bugbot/__init__.py", "/home/pyodide/left.py", "/tmp/left-by-a-program", "/lib/python314.zip"):
    if path == "/tmp/left-by-a-program" and os.path.exists(path): print("OPEN", path)
    try:
        open(path, "w").write("print('OPEN: code that was left')")
    except OSError as error:
        print("closed", error)`,
    },
    {
      name: "the same again, which would find it",
      program: `
import os
print("OPEN" if os.path.exists("/home/pyodide/left.py") and "run-of-its-own" in open("/home/pyodide/left.py").read() else "closed")`,
    },
  ],
};

/** @type {Kind} */
export const FILES_THAT_ARE_NONE = {
  kind: "files that are none",
  ways: [
    {
      name: "open files, processes and devices that folders list",
      program: `
import os
for folder in ("/proc", "/proc/self/fd", "/proc/self/fdinfo", "/dev", "/dev/shm", "/sys", "/mnt", "/root", "/work", "/Users", "C:\\\\"):
    try:
        found = os.listdir(folder)
        print("has", folder, found[:20])
        if folder in ("/sys", "/root", "/work", "/Users") and found: print("OPEN")
    except OSError as error:
        print("closed", folder, error.strerror)
for path in ("/proc/self/exe", "/proc/self/cwd", "/proc/self/fd/0", "/proc/self/fd/3"):
    try:
        print("leads to", os.readlink(path))
        if "node" in os.readlink(path): print("OPEN")
    except OSError as error:
        print("closed", path, error.strerror)
for number in range(3, 40):
    try:
        got = os.read(number, 10)
        if got: print("OPEN", number, got)
    except OSError:
        pass`,
    },
    {
      name: "pipes by name, links in a ring, and terminals",
      program: `
import fcntl, os, select, socket, termios
for attempt in (lambda: os.mkfifo("/tmp/pipe"), lambda: os.openpty(), lambda: socket.socketpair(), lambda: os.symlink("/tmp/ring", "/tmp/ring"), lambda: open("/tmp/ring"), lambda: termios.tcgetattr(0), lambda: fcntl.ioctl(0, 0x5413, bytes(8)), lambda: select.select([0], [], [], 0), lambda: os.sendfile(1, 0, 0, 10), lambda: os.memfd_create("x"), lambda: os.pidfd_open(1), lambda: os.setns(0)):
    try:
        print("no more than in memory:", attempt())
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "a user's and a machine's names",
      program: `
import importlib, os, platform, socket
for ask in (lambda: importlib.import_module("pwd").getpwall(), lambda: importlib.import_module("getpass").getuser(), lambda: os.path.expanduser("~root"), lambda: os.getlogin(), lambda: socket.gethostname(), lambda: platform.node(), lambda: os.uname().nodename):
    try:
        said = str(ask())
        print("says", said[:60])
        if any(word in said for word in ("root:", "/root", ".local")): print("OPEN", said)
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
  ],
};
