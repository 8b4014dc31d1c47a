"""Loops in which no simulated time passes: told soon, and nothing that would end is ended."""

import sys
from collections.abc import Callable
from typing import Any

import pytest

from bugbot.run import Limits, standstill, watchdog
from bugbot.run.limits import Meter
from bugbot.trace import Trace

Run = Callable[..., Any]


@pytest.fixture(autouse=True)
def _soon(monkeypatch: pytest.MonkeyPatch) -> None:
    """A hundredth of what a program is given, so that a test is a hundredth as long."""
    monkeypatch.setattr(standstill, "MOST_LOOKS", 200)
    monkeypatch.setattr(standstill, "_FIRST_TRY", 50)
    monkeypatch.setattr(standstill, "_TRIES", 40)


LOOKS = "at 0 s: the depth sensor was used 200 times and no simulated time passed"
ASKS = "asks again and again and no simulated time passes, so the answer stays the same."
REPEATS = "does the same again and again, and no simulated time passes."


@pytest.mark.parametrize(
    ("program", "line", "why", "remedy"),
    [
        ("forward(50)\nwhile distance() > 20:\n    pass", 3, LOOKS, 3),
        ("while True:\n    d = distance()\n    if d < 20:\n        break", 3, LOOKS, 2),
        ("while distance() > 20:\n    forward(50)", 2, LOOKS, 2),
        ("n = 0\nwhile min(d for a, d in scan()) > 20:\n    n += 1", 3, LOOKS, 3),
        ("def far():\n    return distance() > 20\nwhile far():\n    pass", 3, LOOKS, 4),
        ("while heading() < 90:\n    right(30)", 3, ASKS, 2),
        ("while clock() < 5:\n    forward(50)", 3, ASKS, 2),
        ("while position()[1] < 50:\n    forward(50)", 3, ASKS, 2),
        ("robot = connect()\nwhile robot.heading() < 9:\n    pass", 3, ASKS, 3),
        ("while True:\n    x, y, facing = odometry()\n    if y > 9:\n        break", 3, ASKS, 2),
    ],
)
def test_asking_without_waiting_is_told_with_line_and_remedy(
    run_calls: Run, program: str, line: int, why: str, remedy: int
) -> None:
    ran = run_calls(program)
    assert ran.status == "limit"
    assert ran.message.startswith(f"Stopped on line {line} at 0 s: ")
    assert why in ran.message
    assert ran.message.endswith(f"Put wait(0.1) into the loop on line {remedy}.")


def test_the_moment_at_which_time_stands_still_is_named(run_calls: Run) -> None:
    ran = run_calls("wait(1.5)\nwhile heading() < 90:\n    pass")
    assert ran.message.startswith("Stopped on line 3 at 1.5 s: ")


@pytest.mark.parametrize(
    ("program", "advice"),
    [
        ("i = 0\nwhile i < 10:\n    print(i)", "If it counts, change i in it;"),
        ("x = 3\nwhile x > 0:\n    print(x)\n    x == x - 1", "If it counts, change x in it;"),
        ("while True:\n    print('hello')", "have something in it change;"),
        ("while True:\n    led('red')\n    led('off')", "have something in it change;"),
        ("while True:\n    wait(0)", "put wait(0.1) into it."),
        ("grid = [[0] * 9]\nwhile not grid[0][3]:\n    print(len(grid))", "change;"),
    ],
)
def test_a_loop_that_repeats_itself_is_told_soon(run_calls: Run, program: str, advice: str) -> None:
    ran = run_calls(program)
    assert ran.status == "limit"
    assert REPEATS in ran.message
    assert advice in ran.message
    assert len(ran.console) < 1_000


ENDS_BY_ITSELF = [
    "for i in range(5_000):\n    distance()\n",
    "readings = []\nwhile len(readings) < 3_000:\n    readings.append(distance())\n",
    "n = 0\nwhile n < 3_000:\n    distance()\n    n += 1\n",
    "n = 0\nwhile n < 900:\n    n += 1\n    position()\n",
    "total = 0.0\nwhile total < 90:\n    total += 0.1\n    print('x', end='')\n",
    "steps = iter([1] * 900)\nwhile next(steps, 0):\n    position()\n",
    "def ones():\n    yield from [1] * 900\nit = ones()\nwhile next(it, 0):\n    print()\n",
    "for each in [7] * 900:\n    print(each)\n",
    "import random\nwhile random.random() < 0.995:\n    print('x', end='')\n",
    "import secrets\nwhile secrets.randbelow(300):\n    print('x', end='')\n",
    "class Count:\n    n = 0\n    def on(self):\n        self.n += 1\n        return self.n < 900\n"
    "count = Count()\nwhile count.on():\n    heading()\n",
    "def counter():\n    n = 0\n    def on():\n        nonlocal n\n        n += 1\n"
    "        return n < 900\n    return on\non = counter()\nwhile on():\n    heading()\n",
    "def walk():\n    while True:\n        yield position()\n"
    "for place, _ in zip(walk(), range(900)):\n    pass\n",
    "def walk():\n    while True:\n        yield position()\n"
    "def main():\n    for place, _ in zip(walk(), range(900)):\n        pass\nmain()\n",
    "while distance() > 96:\n    pass\n",  # noise gets there, once in a while
    "queue = list(range(900))\nwhile queue:\n    queue.pop()\n    print('x', end='')\n",
    "import collections\nq = collections.deque([1] * 900)\nwhile q:\n    q.pop()\n    clock()\n",
    "while clock() < 1:\n    wait(0.01)\n    for i in range(9):\n        distance()\n",
]


@pytest.mark.parametrize("program", ENDS_BY_ITSELF)
def test_a_program_that_would_end_is_not_ended(run_calls: Run, program: str) -> None:
    ran = run_calls(program + "led('green')")
    assert ran.message.startswith("Finished")
    assert len(ran.of_kind("led")) == 1


def test_the_same_program_is_ended_at_the_same_event(run_calls: Run) -> None:
    program = "while distance() > 20:\n    print(1)"
    first, second = run_calls(program), run_calls(program)
    assert first.trace.events == second.trace.events


@pytest.mark.parametrize(
    ("program", "what"),
    [
        ("for i in range(10**6):\n    scan()", "most of it readings of the depth sensor:"),
        ("for i in range(10**6):\n    print(i)", "most of it printed text:"),
        ("for i in range(10**6):\n    draw('a', [(i % 200, 0)] * 50)", "most of it drawing:"),
        ("for i in range(10**6):\n    plot('a', i)", "most of it plots, lights and movement:"),
    ],
)
def test_the_limit_of_a_trace_says_what_has_filled_it(
    run_calls: Run, program: str, what: str
) -> None:
    ran = run_calls(program, limits=Limits(trace_bytes=300_000))
    assert ran.status == "limit"
    assert what in ran.message
    assert ("Draw less often" in ran.message) == ("drawing" in what)


# -- the notice in real time -----------------------------------------------------


class RealTime:
    """Real time, which a test moves on."""

    def __init__(self) -> None:
        self.t = 0.0

    def monotonic(self) -> float:
        return self.t


def test_a_standstill_is_noticed_once_and_again_after_time_has_passed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    real = RealTime()
    monkeypatch.setattr(watchdog, "monotonic", real.monotonic)
    simulated = [0.0]
    noticed: list[float] = []
    meter = Meter(Limits(), Trace("", {}, 0), "program.py")
    clock = watchdog._Clock(meter, lambda: simulated[0], lambda line: noticed.append(real.t))
    code = compile("look(sys._getframe)", "program.py", "exec")
    for tick in range(1, 100):
        real.t = tick / 10
        if tick == 50:
            simulated[0] = 1.0
        exec(code, {"look": clock.still_s, "sys": sys})
    assert noticed == [1.5, 6.5]


def test_the_line_that_computes_is_named_and_no_part_of_the_trace(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(watchdog, "STILL_S", 0.02)
    monkeypatch.setattr(watchdog, "_LOOK_EVERY_S", 0.01)
    lines: list[int] = []
    program = "n = 0\nwhile n < 3_000_000:\n    n += 1\n"
    noticed = run(program, on_still=lines.append)
    assert lines in ([2], [3])
    assert noticed.trace.events == run(program).trace.events


def test_importing_is_no_standstill(monkeypatch: pytest.MonkeyPatch) -> None:
    """Python's own loader is at work: NumPy takes a while."""
    monkeypatch.setattr(watchdog, "STILL_S", 0.0)
    told: list[int] = []
    meter = Meter(Limits(), Trace("", {}, 0), "program.py")
    clock = watchdog._Clock(meter, lambda: 0.0, told.append)
    loader = compile("look(sys._getframe)", "<frozen importlib._bootstrap>", "exec")
    program = compile("exec(loader)", "program.py", "exec")
    exec(program, {"look": clock.still_s, "sys": sys, "loader": loader})
    assert told == []
    exec(compile("look(sys._getframe)", "program.py", "exec"), {"look": clock.still_s, "sys": sys})
    assert told == [1]
