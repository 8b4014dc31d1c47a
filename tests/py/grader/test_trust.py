"""A trace that can't be true is seen through, and an honest one never is."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections.abc import Callable
from typing import Any

import pytest

from bugbot import worlds
from bugbot.run import run_program
from bugbot.sim.simulator import Simulator
from bugbot.trace import Trace
from bugbot.worlds import World
from grader.failures import CheckFailed
from grader.runs import Run
from grader.traces import trace_from
from grader.trust import doubt
from performer.values import MalformedError

WORLD = worlds.load("post-and-shelf")

DRIVES = {
    "standing": "wait(5)\nscan()",
    "turning": "right(100)\nfor _ in range(20):\n    scan()\n    wait(0.13)",
    "all at once": """
drive(100, 100, 100)
for _ in range(50):
    scan()
    distance()
    wait(0.07)
""",
    "along a wall": "drive(40, 100, 0)\nwait(20)\nscan()\nbackward(30, 50)\nscan()",
    "odd times": """
drive(30, -20, 7)
for n in range(60):
    wait(0.001 * n)
    scan()
turn(-90)
turn(1e-6)
scan()
""",
}


def keep_moves(trace: Trace) -> None:
    trace.moves = []


def ran(program: str, world: World | str, seed: int = 3) -> Trace:
    """A run as a performer makes it."""
    return run_program(f"from bugbot import *\n{program}", world, seed, trace_ready=keep_moves)


@pytest.mark.parametrize("name", DRIVES)
@pytest.mark.parametrize("world", worlds.names())
def test_an_honest_run_is_believed(name: str, world: str) -> None:
    trace = ran(DRIVES[name], world)
    assert next(trace.of_kind("end"))["status"] == "finished"
    assert doubt(trace, worlds.load(world)) is None


ERRORS = World.from_dict(
    {**WORLD.to_dict(), "odometry": {"drift_deg_s": -0.3, "turn_scale": 1.3, "slip": 0.2}}
)


@pytest.mark.parametrize("name", DRIVES)
def test_an_honest_run_of_a_robot_with_errors_is_believed(name: str) -> None:
    trace = ran(DRIVES[name], ERRORS)
    assert doubt(trace, ERRORS) is None


def test_what_one_robot_can_do_is_too_fast_for_another() -> None:
    slower = World.from_dict({**WORLD.to_dict(), "odometry": {"turn_scale": 0.9, "slip": 0.1}})
    for program in ("right(100)\nwait(1)", "drive(100, 100, 0)\nwait(1)"):
        found = doubt(ran(program, WORLD), slower)
        assert found is not None
        assert found[0].startswith("the robot is somewhere it can't have")


def honest() -> Trace:
    """Ten looks while it drives, then into the wall, twice; a map drawn and a value plotted."""
    program = "forward(50)\nfor _ in range(10):\n    scan()\n    wait(0.1)\ndraw('a', [(1, 2)])\n"
    program += "plot('b', 1)\nbackward(100)\nwait(9)\nforward(60, distance=5)\nbackward(100, 60)"
    return ran(program, WORLD)


def replaced(kind: str, index: int, place: int, change: Callable[[Any], Any]) -> Trace:
    """An honest trace with one value changed: of the event of a kind with that index."""
    trace = honest()
    at = [n for n, event in enumerate(trace.events) if event[0] == kind][index]
    event = list(trace.events[at])
    event[place] = change(event[place])
    trace.events[at] = tuple(event)
    return trace


@pytest.mark.parametrize(
    ("trace", "reason"),
    [
        (replaced("pose", 5, 3, lambda y: y + 1), "somewhere it can't have driven"),
        (replaced("pose", 5, 4, lambda h: h + 10), "somewhere it can't have driven or turned"),
        (replaced("pose", 0, 2, lambda x: x + 1), "somewhere it can't have driven"),
        (replaced("scan", 3, 2, lambda x: x + 30), "somewhere it can't have driven"),
        (replaced("scan", 3, 5, lambda b: [b[0], b[1] + 1, *b[2:]]), "read what it can't read"),
        (replaced("scan", 3, 5, lambda b: [b[0] + 1, *b[1:]]), "looked where it has no beams"),
        (replaced("scan", 3, 5, lambda b: [*b, 30.0, 50.0]), "looked where it has no beams"),
    ],
)
def test_a_changed_record_is_doubted(trace: Trace, reason: str) -> None:
    found = doubt(trace, WORLD)
    assert found is not None
    assert reason in found[0]


def without(kind: str, index: int = 0) -> Trace:
    """An honest trace from which an event has been wiped."""
    trace = honest()
    at = [n for n, event in enumerate(trace.events) if event[0] == kind][index]
    del trace.events[at]
    return trace


def with_moves(change: Callable[[list[Any]], Any]) -> Trace:
    trace = honest()
    assert trace.moves is not None
    change(trace.moves)
    return trace


def with_events(change: Callable[[list[Any]], Any]) -> Trace:
    trace = honest()
    change(trace.events)
    return trace


BUMPS = "what it ran into has been changed"
DROVE = "somewhere it can't have driven"


@pytest.mark.parametrize(
    ("trace", "reason"),
    [
        (without("bump"), BUMPS),
        (without("bump", -1), BUMPS),
        (replaced("bump", 0, 2, lambda x: x + 1), BUMPS),
        (with_events(lambda rows: rows.insert(3, ("bump", rows[3][1], 1.0, 2.0))), BUMPS),
        (without("scan", 4), "looks is not that of the sensor|gap"),
        (without("pose", 7), DROVE),
        (without("pose", -1), "gap"),
        (with_events(lambda rows: rows.insert(-1, ("pose", rows[-1][1], 1.0, 2.0, 3.0))), "gap"),
        (with_moves(lambda moves: moves.clear()), "gap|looks"),
        (with_moves(lambda moves: moves.pop(0)), "gap|looks|driven"),
        (with_moves(lambda moves: moves.insert(5, 8)), "looks|gap"),
        (with_moves(lambda moves: moves.insert(0, [100, 0, 0, 1.0, False])), f"{DROVE}|looks"),
        (with_moves(lambda moves: moves.append([0, 0, 0, 1.0, False])), f"{DROVE}|gap"),
        (replaced("layer", 0, 1, lambda t: t + 0.01), r"\(layer\) from when no"),
        (replaced("plot", 0, 1, lambda t: t + 0.01), r"\(plot\) from when no"),
        (replaced("end", 0, 1, lambda t: t + 1), r"\(end\) from when no"),
    ],
)
def test_what_is_wiped_or_added_is_seen(trace: Trace, reason: str) -> None:
    found = doubt(trace, WORLD)
    assert found is not None
    assert re.search(reason, found[0])


def test_a_record_without_its_moves_is_none() -> None:
    trace = honest()
    trace.moves = None
    assert doubt(trace, WORLD) == ("there is no record of how the robot was driven", 0.0)


def test_an_honest_run_has_bumps_to_lose() -> None:
    trace = honest()
    assert sum(1 for _ in trace.of_kind("bump")) == 2
    assert doubt(trace, WORLD) is None


def test_moves_without_end_are_not_made() -> None:
    """Each of them is possible; together they would keep the judge for ever."""
    forever = with_moves(lambda moves: moves.extend([[0, 0, 100, 10.0, True]] * 1_000_000))
    assert doubt(forever, WORLD) is not None


def test_looks_without_end_are_not_made(monkeypatch: pytest.MonkeyPatch) -> None:
    """They take no time, and each leaves a record: a million would fill the judge's memory."""
    looks = 0
    real = Simulator.scan

    def counted(sim: Simulator) -> Any:
        nonlocal looks
        looks += 1
        return real(sim)

    forever = with_moves(lambda moves: moves.extend([8] * 1_000_000))
    monkeypatch.setattr(Simulator, "scan", counted)
    assert doubt(forever, WORLD) is not None
    assert looks < 1000


def test_readings_are_held_against_the_seed() -> None:
    trace = honest()
    trace.header["seed"] = 4
    found = doubt(trace, WORLD)
    assert found is not None
    assert "read what it can't read there" in found[0]


# -- the form ----------------------------------------------------------------------


def packed(trace: Trace) -> dict[str, Any]:
    events, points = trace.take()
    return {"events": events, "points": b64encode(points).decode(), "moves": trace.moves}


def test_a_trace_comes_through_as_it_was() -> None:
    program = "from bugbot import *\ndraw('a', [(1, 2)])\nprint(1)\nscan()\nled('red')\nbeep(440)"
    trace = run_program(program, WORLD, 3, trace_ready=keep_moves)
    events = list(trace.events)
    again = trace_from(packed(trace), WORLD.to_dict(), 3, 10)
    assert again.events == events
    assert again.moves == trace.moves == [8]
    assert again.points_of(next(again.of_kind("layer"))) == [(1, 2)]


END = ["end", 1.0, "finished", ""]


@pytest.mark.parametrize(
    "rows",
    [
        "no list",
        [],
        [["pose", 0, 1, 2, 3]],
        [["pose", 0, 1, 2], END],
        [["end", 0.0, "finished", ""], END],
        [["flight", 0], END],
        [[1], END],
        [[], END],
        [["pose", 0, "1", 2, 3], END],
        [["pose", 0, 1, 2, float("nan")], END],
        [["pose", -1, 1, 2, 3], END],
        [["pose", 2, 1, 2, 3], END],
        [["pose", True, 1, 2, 3], END],
        [["end", 11.0, "finished", ""]],
        [["scan", 0, 1, 2, 3, [1]], END],
        [["scan", 0, 1, 2, 3, "11"], END],
        [["scan", 0, 1, 2, 3, [1, None]], END],
        [["layer", 0, "a", "red", "dots", 2, 0, 2, None], END],
        [["layer", 0, "a", "red", "dots", 2, -1, 1, None], END],
        [["layer", 0, "a", "red", "dots", 2, 0, 1, [1]], END],
        [["print", 0, "stdout", 1], END],
        [["line", 0, None], END],
        [["fault", 0, "E", "m", "one", None, ""], END],
        [["fault", 0, "E", "m", 1, 7, ""], END],
    ],
)
def test_rows_that_are_no_trace_are_refused(rows: Any) -> None:
    data = {"events": json.dumps(rows), "points": b64encode(b"\0\0\0\0").decode(), "moves": []}
    with pytest.raises(MalformedError):
        trace_from(data, WORLD.to_dict(), 3, 10)


@pytest.mark.parametrize(
    "moves",
    [
        None,
        {},
        [3],
        [True],
        ["8"],
        [[1, 2, 3, 4]],
        [[1, 2, 3, 4, 1]],
        [[1, 2, 3, -1, False]],
        [[1, 2, 3, 11.0, False]],
        [[1, 2, float("nan"), 1, False]],
        [[1, 2, 10**400, 1, False]],
        [[1, 2, None, 1, False]],
    ],
)
def test_moves_that_are_none_are_refused(moves: Any) -> None:
    data = {"events": json.dumps([END]), "points": "", "moves": moves}
    with pytest.raises(MalformedError):
        trace_from(data, WORLD.to_dict(), 3, 10)


@pytest.mark.parametrize(
    "data",
    [
        None,
        {},
        {"events": "[", "points": ""},
        {"events": "[]", "points": "!"},
        "text",
        {"events": 1},
    ],
)
def test_what_is_no_trace_at_all_is_refused(data: Any) -> None:
    with pytest.raises(MalformedError):
        trace_from(data, WORLD.to_dict(), 3, 10)


def test_a_run_without_a_record_is_the_programs_failure() -> None:
    job = {"id": "run-1", "world": WORLD.to_dict(), "seed": 3, "limits": {"simulated_s": 10}}
    run = Run.of(job, {"id": "run-1", "trace": {"events": "[]", "points": ""}})
    with pytest.raises(CheckFailed, match="left no record that can be read"):
        run.must_have_ended()
    assert run.layers() == {}
