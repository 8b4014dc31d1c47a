"""What many tests need: a run of a few lines of program, and a link to call the robot directly."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest
from hypothesis import settings

from bugbot import worlds
from bugbot.link import Link, connected
from bugbot.run import Limits, outcome_of, run_program
from bugbot.run.limits import Meter
from bugbot.trace import Trace
from bugbot.worlds import World

# A slow machine is no failure, and a red test must be red again when it is run again.
settings.register_profile("here", deadline=None, derandomize=True)
settings.load_profile("here")


GOLDEN = Path(__file__).parent / "golden"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--rewrite-golden", action="store_true", help="write tests/golden/ anew; review the diff"
    )


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Callable[[str, str], None]:
    """Compares a text with a file of tests/golden/, or writes it with --rewrite-golden."""

    def compare(name: str, text: str) -> None:
        file = GOLDEN / name
        if request.config.getoption("--rewrite-golden"):
            file.write_text(text, encoding="utf-8")
        assert text == file.read_text(encoding="utf-8"), f"{name} has changed: --rewrite-golden?"

    return compare


@dataclass(frozen=True)
class Ran:
    """A finished run: its trace, and its outcome by name."""

    trace: Trace
    outcome: dict[str, Any]

    def __getattr__(self, name: str) -> Any:
        return self.outcome[name]

    def of_kind(self, kind: str) -> list[dict[str, Any]]:
        return list(self.trace.of_kind(kind))


def _run(program: str, world: Any = "empty", seed: int = 1, **options: Any) -> Ran:
    trace = run_program(dedent(program).lstrip("\n"), world, seed, **options)
    return Ran(trace, outcome_of(trace))


@pytest.fixture
def run() -> Callable[..., Ran]:
    """Runs a program given as an indented text; line 1 is the first that is not empty."""
    return _run


@pytest.fixture
def run_calls() -> Callable[..., Ran]:
    """The same with `from bugbot import *` before it, on line 1."""

    def run_with_calls(program: str, *world_and_seed: Any, **options: Any) -> Ran:
        return _run(
            "from bugbot import *\n" + dedent(program).lstrip("\n"), *world_and_seed, **options
        )

    return run_with_calls


def link_on(world: World | str, seed: int = 1) -> Link:
    """A link without a program, for calling the robot from a test."""
    loaded = worlds.load(world) if isinstance(world, str) else world
    trace = Trace("", loaded.to_dict(), seed)
    return Link(loaded, seed, trace, "program.py", Meter(Limits(), trace, "program.py"))


@pytest.fixture
def robot() -> Iterator[Link]:
    """The robot's calls act on a robot in the middle of the empty mat."""
    with connected(link_on("empty")) as link:
        yield link


def world_with(
    *obstacles: tuple[float, float, float, float], at: tuple[float, ...] = (100, 100, 0)
) -> World:
    """A world with these rectangles (x, y, width, height) and the robot at (x, y, heading)."""
    return World.from_dict(
        {
            "name": "made",
            "title": "Made for a test",
            "description": "As the test says.",
            "obstacles": [
                {"x": x, "y": y, "width": width, "height": height, "name": f"box {number}"}
                for number, (x, y, width, height) in enumerate(obstacles)
            ],
            "start": dict(zip(("x", "y", "heading"), at, strict=True)),
        }
    )


@pytest.fixture
def make_world() -> Callable[..., World]:
    """`world_with`, for tests that need a world solved by hand."""
    return world_with


@pytest.fixture
def make_link() -> Callable[..., Link]:
    """`link_on`."""
    return link_on
