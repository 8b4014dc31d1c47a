/** What outlives a run, or waits in the page for the next one. */
import { ADDRESSES, WALK } from "./tools.mjs";

/** Finds the two kinds of Pyodide's event loop that the collector or a class knows, and makes one. */
const LOOPS = `${WALK}
def loops():
    def below(kind):
        for each in type.__subclasses__(kind):
            yield each
            yield from below(each)
    import asyncio
    for kind in below(asyncio.AbstractEventLoop):
        try:
            yield kind()
        except Exception as error:
            print("closed", kind.__name__, type(error).__name__)
    yield from (one for one in gc.get_objects() if isinstance(one, asyncio.AbstractEventLoop))
`;

/** A million bytes that no program has by chance. */
const MARKED = `${ADDRESSES}
marked = numpy.resize(numpy.arange(251, 0, -1, dtype=numpy.uint8), 1_000_000)
`;

/** @type {import("./tools.mjs").Kind} */
export const WHAT_OUTLIVES_A_RUN = {
  kind: "what outlives a run",
  ways: [
    {
      name: "timers of every loop, which print in the next run",
      program: `${LOOPS}
late = '[["print",0,"stdout","OPEN: after the run\\\\n"]]'
senders = handles()
for loop in loops():
    for set in (lambda: loop.call_later(0.3, lambda: [send(late, b"") for send in senders]), lambda: loop.call_soon(print, "set"), lambda: loop.create_task(print), lambda: loop.run_in_executor(None, print, "at once")):
        try:
            print("set", set())
        except BaseException as error:
            print("closed", type(error).__name__)`,
    },
    {
      name: "coroutines that nobody waits for",
      program: `${WALK}
import asyncio
async def never():
    try:
        await asyncio.sleep(1e9)
    finally:
        walk(handles(), 100)
        print("ended")
async def main():
    global kept
    kept = [asyncio.ensure_future(never()) for each in range(3)]
    await asyncio.sleep(0)
    raise KeyboardInterrupt
try:
    asyncio.run(main())
except BaseException as error:
    print("closed", type(error).__name__)
one = never()
one.send(None)
sys.kept = one`,
    },
    {
      name: "a mark in memory that no snapshot may keep",
      spoils: true,
      program: `${MARKED}
sys_kept = [marked.copy() for each in range(20)]
import sys
sys.kept = sys_kept
print("marked")`,
    },
    {
      name: "another run, which would find that mark",
      spoils: true,
      program: `${MARKED}
rooms = [numpy.zeros(1_000_000, dtype=numpy.uint8) for each in range(25)]
end = max(room.__array_interface__["data"][0] for room in rooms)
found = 0
for address in range(1024, end, 5_000_000):
    found += bytes(at(address, min(5_000_000, end - address), "|u1")).count(bytes(marked[:251]))
if found > 10 * 3984: print("OPEN", found)
print("found", found)`,
    },
    {
      name: "a run that ends, and tells more",
      spoils: true,
      program: `${WALK}
from bugbot import *
for send in handles():
    for told in ('[["end",0,"finished","OPEN"]]', '[["print",9e9,"stdout","later"]]', '[["fault",0,"<img src=x onerror=REACHED=1>","<script>REACHED=1</script>",1,"<a href=javascript:REACHED=1>x</a>","x"]]', '[["end",0,"fault","<b>x</b>"]]', '[["end",0,"finished","twice"]]'):
        try:
            send(told, b"")
        except BaseException as error:
            pass
wait(1)
print("closed")`,
    },
    {
      name: "the process's own input and output",
      program: `
import os, sys
for number in (1, 2, 3):
    try:
        os.write(number, b"OPEN: past the trace\\nresult {}\\n" if number < 3 else b"x")
    except OSError as error:
        print("closed", error.strerror)
for read in (lambda: os.read(0, 10), lambda: sys.__stdin__.read(1), lambda: open("/dev/stdin").read(1), lambda: input()):
    try:
        got = read()
        print("OPEN" if got else "closed", repr(got))
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
  ],
};
