"""asyncio on simulated time: when every task waits, the robot's time passes.

May import: the standard library, `bugbot.errors`, `bugbot.link`.

Nothing comes in from outside while a program runs, so the loop has no use for a selector: it
lets time pass until the next timer. Imported only by programs that import asyncio.
"""

from __future__ import annotations

import asyncio
import sys
from asyncio import events, runners
from collections.abc import Callable
from contextlib import ExitStack
from types import FrameType, ModuleType
from typing import Any, NoReturn

from bugbot.errors import NoNetworkError, NoThreadError, StuckError
from bugbot.link import Link

__all__ = ["SimulatedLoop", "use_simulated_loops"]

_RESOLUTION_S = 1e-6
"""A timer this near is due: simulated time is kept to 1e-9 s, and a sum may be just beside it."""

_OUTSIDE = (
    "connect_accepted_socket",
    "connect_read_pipe",
    "connect_write_pipe",
    "create_connection",
    "create_datagram_endpoint",
    "create_server",
    "create_unix_connection",
    "create_unix_server",
    "getaddrinfo",
    "getnameinfo",
    "sock_accept",
    "sock_connect",
    "sock_recv",
    "sock_sendall",
    "start_tls",
    "subprocess_exec",
    "subprocess_shell",
)
"""What a loop does for the world outside, of which there is none."""


class SimulatedLoop(asyncio.BaseEventLoop):
    """An event loop whose clock is the run's."""

    def __init__(self, link: Link) -> None:
        super().__init__()
        self._link = link
        self._clock_resolution = _RESOLUTION_S
        self._selector = self
        self._tasks_made = 0
        self.set_task_factory(_named_task)

    def __del__(self) -> None:
        """Says nothing of a loop left open: when it would be said depends on the machine."""

    def time(self) -> float:
        """Simulated seconds since the program started."""
        return self._link.now()

    # -- what BaseEventLoop asks of a selector -----------------------------------

    def select(self, timeout: float | None) -> list[Any]:
        """Let time pass until the next timer is due."""
        if timeout is None:
            waits = self._line_of(_waiting_task(self))
            where = "" if waits is None else f" on line {waits}"
            raise StuckError(
                f"the program waits{where} for something that can't come: no task is left that "
                "could bring it"
            )
        self._link.check()
        if timeout > 0:
            self._link.advance(timeout, line=self._line_of(self._next_task()))
        return []

    def _process_events(self, event_list: list[Any]) -> None:
        """There are none."""

    def _write_to_self(self) -> None:
        """Nobody sleeps who would have to be woken."""

    # -- whose line it is ----------------------------------------------------------

    def _next_task(self) -> asyncio.Task[Any] | None:
        """The task that the next timer wakes, where that can be seen."""
        timers: list[Any] = self._scheduled  # type: ignore[attr-defined]
        for part in timers[0]._args or () if timers else ():
            for call, _ in getattr(part, "_callbacks", None) or ():
                task = getattr(call, "__self__", None)
                if isinstance(task, asyncio.Task):
                    return task
        return None

    def _line_of(self, task: asyncio.Task[Any] | None) -> int | None:
        """The line of the program on which a task waits."""
        step: Any = None if task is None else task.get_coro()
        line = None
        while step is not None:
            frame: FrameType | None = getattr(step, "cr_frame", None)
            if frame is not None and frame.f_code.co_filename == self._link.filename:
                line = frame.f_lineno
            step = getattr(step, "cr_await", None)
        return line

    # -- what there is not ----------------------------------------------------------

    def run_in_executor(self, *_: Any) -> Any:  # type: ignore[override]
        """Refuse: it would need a thread."""
        raise NoThreadError(
            "a program can't start threads, and to_thread() and run_in_executor() need one: "
            "call the function itself"
        )

    def call_exception_handler(self, context: dict[str, Any]) -> None:
        """Tell of an error that nobody has asked a task for, as plainly as the rest is told."""
        error = context.get("exception")
        words = context.get("message", "an error in a task")
        told = words if error is None else f"{words}: {type(error).__name__}: {error}"
        print(told, file=sys.stderr)


def _refusing(name: str) -> Callable[..., Any]:
    async def refuse(self: SimulatedLoop, *_: Any, **__: Any) -> NoReturn:
        raise NoNetworkError(
            f"asyncio's {name}() has nobody to talk to: a program here has no network and starts "
            "no other programs"
        )

    return refuse


for _name in _OUTSIDE:
    setattr(SimulatedLoop, _name, _refusing(_name))


def _named_task(loop: Any, coro: Any, **options: Any) -> asyncio.Task[Any]:
    """A task, numbered within the run: asyncio's own numbers go on from run to run."""
    loop._tasks_made += 1
    name = options.pop("name", None)
    if name is None:
        name = f"Task-{loop._tasks_made}"
    return asyncio.Task(coro, loop=loop, name=name, **options)


def _waiting_task(loop: SimulatedLoop) -> asyncio.Task[Any] | None:
    tasks = sorted(asyncio.all_tasks(loop), key=lambda task: task.get_name())
    return tasks[0] if tasks else None


def use_simulated_loops(package: ModuleType, undo: ExitStack, link: Link) -> None:
    """Have asyncio make loops of this kind, in a browser as well, until `undo` is done."""
    current: list[Any] = [None]

    def new_event_loop() -> SimulatedLoop:
        return SimulatedLoop(link)

    def set_event_loop(loop: Any) -> None:
        current[0] = loop

    def get_event_loop() -> Any:
        running = events._get_running_loop()
        if running is None and current[0] is None:
            current[0] = new_event_loop()
        return running or current[0]

    names = {
        "new_event_loop": new_event_loop,
        "set_event_loop": set_event_loop,
        "get_event_loop": get_event_loop,
    }
    for module in (package, events):
        undo.callback(vars(module).update, dict(vars(module)))
        vars(module).update(names)
    # Pyodide's own run() asks JavaScript, and its loop seems to be running all the time.
    vars(package)["run"] = runners.run
    undo.callback(events._set_running_loop, events._get_running_loop())
    events._set_running_loop(None)
