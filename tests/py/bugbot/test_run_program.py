"""A program and its end: what comes out, what is the same every time, what is put back."""

import builtins
import json
import linecache
import math
import os
import random
import signal
import sys
import threading
import time
import warnings
from collections.abc import Callable
from textwrap import dedent
from typing import Any

import pytest

import bugbot
from bugbot import worlds
from bugbot.errors import WorldError
from bugbot.link import NoRobotError
from bugbot.run import Limits, outcome_of, run_program
from bugbot.trace import Trace, TraceError

Run = Callable[..., Any]

TOUR = """
drive(40, 10, 25)
for tick in range(60):
    free = [(x, 5 * tick) for x, _ in scan()]
    draw("seen", free, "#9ecae1", "squares", 5)
    plot("ahead", distance())
    if tick == 30:
        forward(100, distance=500)
        drive(-30, 0, 60)
        led("green")
        beep(880)
        print("turned", random.random(), odometry())
    wait(0.1)
turn(-90)
"""


@pytest.mark.parametrize("name", worlds.names())
def test_every_world_keeps_the_contract_of_a_run(run: Run, name: str) -> None:
    """Times in order, one end at the end, JSON all through, the same twice, other noise else."""
    first = run("import random\nfrom bugbot import *\n" + TOUR, name, 5)
    again = run("import random\nfrom bugbot import *\n" + TOUR, name, 5)
    other = run("import random\nfrom bugbot import *\n" + TOUR, name, 6)
    assert first.outcome == again.outcome
    assert first.trace.events == again.trace.events
    assert first.trace.points == again.trace.points
    assert first.trace.events != other.trace.events
    events = first.trace.events
    assert events[0][0] == "pose"
    assert [event[0] for event in events].count("end") == 1
    assert events[-1][0] == "end"
    assert [event[1] for event in events] == sorted(event[1] for event in events)
    assert json.loads(json.dumps(first.outcome)) == first.outcome
    assert first.status == "finished"
    assert first.seconds > 6
    assert list(first.layers) == ["seen"]
    assert len(first.series["ahead"]) == 60
    assert {event[0] for event in events} >= {
        "scan",
        "layer",
        "plot",
        "print",
        "led",
        "beep",
        "line",
    }


def test_a_seed_changes_the_noise_and_not_the_motion(run_calls: Run) -> None:
    one, two = (run_calls("forward(50, 20)\nprint(scan())", "empty", seed) for seed in (1, 2))
    assert one.pose == two.pose
    assert one.console != two.console


def test_the_outcome_has_exactly_these_parts(run_calls: Run) -> None:
    ran = run_calls("""
        import sys
        print("to both")
        print("streams", file=sys.stderr)
        draw("gone", [(1, 2)])
        draw("gone", [])
        draw("goal", [(1, 2)], "red", "text", 4)
        forward(101)
        wait(1)
        plot("a", 1)
    """)
    assert ran.outcome == {
        "status": "finished",
        "message": "Finished after 1 s.",
        "seconds": 1.0,
        "console": "to both\nstreams\n",
        "notes": [
            {
                "line": 8,
                "text": "forward(speed, distance) got speed 101, and the robot can't go "
                "faster than 100 per cent: it counts as 100",
            }
        ],
        "pose": {"x": 100.0, "y": 111.5, "heading": 0.0},
        "series": {"a": [[1.0, 1.0]]},
        "layers": {
            "gone": {"shape": "dots", "size": 2.0, "colour": "black", "points": []},
            "goal": {
                "shape": "text",
                "size": 4.0,
                "colour": "red",
                "points": [[1.0, 2.0]],
                "texts": ["goal"],
            },
        },
        "fault": None,
    }
    assert [event["stream"] for event in ran.of_kind("print")] == ["stdout", "stderr"]


def test_a_trace_without_an_end_has_no_outcome() -> None:
    with pytest.raises(TraceError, match="cut short"):
        outcome_of(Trace("", {}, 0))


def test_a_world_may_be_given_by_name_as_data_or_ready(run: Run) -> None:
    world = worlds.load("doorway")
    runs = [run("print(1)", given) for given in ("doorway", world.to_dict(), world)]
    assert runs[0].trace.header == runs[1].trace.header == runs[2].trace.header
    assert runs[0].trace.header["world"] == world.to_dict()


@pytest.mark.parametrize("world", ["nowhere", {"name": "half"}])
def test_a_world_that_is_none_is_the_callers_fault(world: Any) -> None:
    with pytest.raises(WorldError):
        run_program("print(1)", world, 1)


def test_a_seed_that_is_no_int_is_the_callers_fault() -> None:
    with pytest.raises(TypeError, match=r"a run wants an int for its seed; it got '1'"):
        run_program("print(1)", "empty", "1")  # type: ignore[arg-type]


def test_the_trace_is_handed_out_first_and_may_be_taken_all_along() -> None:
    """As the page does: what is taken in pieces adds up to the whole, and nothing is missed."""
    source = dedent("""
        from bugbot import *
        for i in range(20):
            print(i)
            draw("a", [(i, i)])
            forward(50, 10)
            scan()
        1 / 0
    """)
    pieces: list[Any] = []
    traces: list[Trace] = []

    def take() -> None:
        rows, points = traces[0].take()
        pieces.append((json.loads(rows), points))

    trace = run_program(
        source, "wall-ahead", 3, trace_ready=traces.append, on_flush=take, filename="program.py"
    )
    assert traces == [trace]
    take()
    whole = run_program(source, "wall-ahead", 3)
    rows = [row for piece, _ in pieces for row in piece]
    # Prints of one moment may have been joined in the one and not in the other.
    assert [row for row in rows if row[0] != "print"] == [
        json.loads(json.dumps(event)) for event in whole.events if event[0] != "print"
    ]
    assert "".join(row[3] for row in rows if row[0] == "print") == outcome_of(whole)["console"]
    assert b"".join(points for _, points in pieces) == whole.points.tobytes()
    assert len(pieces) > 40


def test_the_program_is_the_main_module(run: Run) -> None:
    ran = run("""
        import sys, __main__
        from dataclasses import dataclass
        @dataclass
        class P:
            x: int
        if __name__ == "__main__":
            print(sys.modules["__main__"].P(3), __main__.P is P, __file__, sys.argv)
    """)
    assert ran.console == "P(x=3) True program.py ['program.py']\n"


def test_random_follows_the_seed(run: Run) -> None:
    program = "import random\nprint(random.random(), random.choice('abc'), random.gauss(0, 1))"
    assert run(program, seed=4).console == run(program, seed=4).console
    assert run(program, seed=4).console != run(program, seed=5).console
    expected = random.Random(4).random()
    assert run(program, seed=4).console.startswith(f"{expected} ")


def state_of_python() -> dict[str, Any]:
    modules = (builtins, math, os, random, sys, threading, time, bugbot, bugbot.api)
    return {
        "names": {module.__name__: dict(vars(module)) for module in modules},
        "path": list(sys.path),
        "main": sys.modules["__main__"],
        "random": random.getstate(),
        "depth": sys.getrecursionlimit(),
        "thread": threading.Thread.start,
        "interrupt": signal.getsignal(signal.SIGINT),
        "trace": sys.gettrace(),
        "lines": linecache.cache.get("program.py"),
        "warnings": (list(warnings.filters), warnings.showwarning),
    }


VANDAL = """
import builtins, math, os, random, sys, threading, time, warnings
import bugbot
builtins.print = None
builtins.new_name = 3
del builtins.len
math.pi = 3
os.getcwd = None
random.seed(1)
random.random = None
sys.stdout = None
sys.path.append("nowhere")
sys.modules["__main__"] = None
sys.setrecursionlimit(200)
threading.Thread.start = None
time.sleep = None
bugbot.wait = None
bugbot.api.new_name = 1
warnings.simplefilter("error")
"""


@pytest.mark.parametrize(
    "ending", ["", "1 / 0", "sys.exit()", "raise KeyboardInterrupt", "bugbot.api.wait(601)", "x ="]
)
def test_everything_a_program_does_to_python_is_undone(run: Run, ending: str) -> None:
    before = state_of_python()
    run(VANDAL + ending)
    after = state_of_python()
    for part, value in before.items():
        assert after[part] == value, part
    with pytest.raises(NoRobotError):
        bugbot.wait(1)


def test_runs_do_not_see_each_other(run: Run) -> None:
    run("leftover = 1\nimport builtins\nbuiltins.other = 2")
    assert run("print('leftover' in globals())").console == "False\n"
    assert run("other").fault["type"] == "NameError"


def test_warnings_are_shown_in_the_console_whatever_the_host_does_with_them(run: Run) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ran = run("""
            import warnings
            x = 1
            if x is 1:
                warnings.warn("mind the gap")
            warnings.warn("old", DeprecationWarning)
            warnings.warn("later", PendingDeprecationWarning)
            warnings.warn_explicit("elsewhere", UserWarning, "other.py", 7)
        """)
    first, *rest = ran.console.splitlines()
    assert first.startswith('Line 3: SyntaxWarning: "is" with ')
    assert rest == [
        "Line 4: UserWarning: mind the gap",
        "Line 5: DeprecationWarning: old",
        "other.py: UserWarning: elsewhere",
    ]
    assert {event["stream"] for event in ran.of_kind("print")} == {"stderr"}


def test_the_source_is_there_for_pythons_own_tracebacks(run: Run) -> None:
    ran = run("""
        import traceback
        try:
            1 / 0  # here
        except ZeroDivisionError:
            traceback.print_exc()
    """)
    assert "1 / 0  # here" in ran.console


def test_a_byte_order_mark_and_any_line_ends_are_no_trouble(run: Run) -> None:
    assert run("\ufeffprint(1)\r\nprint(2)\rprint(3)\n").console == "1\n2\n3\n"


def test_a_run_in_another_thread_goes_without_the_watchdog() -> None:
    done: list[Trace] = []
    thread = threading.Thread(target=lambda: done.append(run_program("print(1)", "empty", 1)))
    thread.start()
    thread.join()
    assert outcome_of(done[0])["console"] == "1\n"


def test_limits_have_the_figures_of_the_design() -> None:
    assert Limits() == Limits(
        simulated_s=600, silent_s=60, print_bytes=2_000_000, trace_bytes=64_000_000
    )
