"""Who may import whom, held by reading every import of py/ and lessons/.

The arrows point from what a program calls down to plain conventions, and nothing points
back: a simulator that knew the API, or a mapper that could look into the simulator, would
be a mistake however small. Imports inside functions count as well.
"""

import ast
import sys
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

import pytest

ROOT = Path(__file__).resolve().parents[2]
PY, LESSONS = ROOT / "py", ROOT / "lessons"

BASE = ("bugbot.errors", "bugbot.frames", "bugbot.colours")
SIMULATED = (*BASE, "bugbot.trace", "bugbot.worlds", "bugbot.sim")
CALLS = (*SIMULATED, "bugbot.checks", "bugbot.own_clock", "bugbot.link")

MAY_IMPORT: dict[str, tuple[str, ...]] = {
    "bugbot.errors": (),
    "bugbot.frames": (),
    "bugbot.colours": (),
    "bugbot.plain_text": (),
    "bugbot.own_clock": BASE,
    "bugbot.trace": BASE,
    "bugbot.worlds": BASE,
    "bugbot.sim": SIMULATED,
    "bugbot.checks": (*BASE, "bugbot.trace"),
    "bugbot.link": SIMULATED,
    "bugbot.api": CALLS,
    "bugbot.__init__": ("bugbot.api", "bugbot.errors"),
    "bugbot.run": (*CALLS, "bugbot", "bugbot.api", "bugbot.run"),
    "bugbot.picture": (*CALLS, "PIL"),
    "bugbot.supervisor": ("bugbot.trace",),
    "bugbot.cli": (
        *(*CALLS, "bugbot.run", "bugbot.picture"),
        *("bugbot.plain_text", "bugbot.supervisor", "bugbot.shut_in", "sandbox"),
    ),
    "bugbot.shut_in": ("bugbot.run", "bugbot.trace", "bugbot.worlds", "sandbox"),
    "bugbot.__main__": ("bugbot.cli",),
    "mapping": ("bugbot.frames", "bugbot.errors", "mapping", "numpy"),
    "mapping.yaml_text": ("bugbot.errors", "yaml"),
    "performer": ("bugbot", "bugbot.*", "performer"),
    "sandbox": ("sandbox",),
    "grader": ("bugbot", "bugbot.*", "mapping", "performer", "sandbox", "grader"),
    "grader.classes.machines": ("grader", "distributed"),
    "sketch": ("bugbot.frames", "sketch"),
    "bridge": (*("bugbot", "bugbot.run", "bugbot.trace", "bugbot.worlds", "performer", "bridge"),),
    "bridge.seal": ("_pyodide",),
    "bridge.judging": ("grader",),
    "bridge.map_files": ("bugbot.errors",),
    "bridge.ros": ("bugbot.errors", "bridge.map_files", "mapping"),
}
"""Room -> what its modules may import besides the standard library. The longest name that fits
counts; a name allows its submodules too, but "bugbot" alone only the public names."""

A_PROGRAM = ("bugbot", "numpy")
A_CHECK = ("grader", "mapping", "bugbot.frames")
A_PICTURE = ("sketch", "mapping", "bugbot.frames")


def room_of(module: str) -> str:
    fitting = [room for room in MAY_IMPORT if module == room or module.startswith(f"{room}.")]
    assert fitting, f"{module} belongs to no room: add it to MAY_IMPORT, with a reason"
    return max(fitting, key=len)


def imports(source: str) -> Iterator[tuple[int, str]]:
    """Line and full name of each import; `from a import b` counts as a.b where that is a module."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"line {node.lineno}: write the whole name of the module"
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                yield node.lineno, inner if is_module(inner) else str(node.module)


def is_module(name: str) -> bool:
    path = PY.joinpath(*name.split("."))
    return path.with_suffix(".py").exists() or (path / "__init__.py").exists()


def is_allowed(name: str, allowed: tuple[str, ...]) -> bool:
    if name.partition(".")[0] in sys.stdlib_module_names:
        return True
    return any(
        name == each or (each != "bugbot" and name.startswith(f"{each.removesuffix('.*')}."))
        for each in allowed
    )


def forbidden(source: str, allowed: tuple[str, ...]) -> list[str]:
    return [
        f"line {line}: {name}" for line, name in imports(source) if not is_allowed(name, allowed)
    ]


def module_name(path: Path) -> str:
    name = ".".join(path.relative_to(PY).with_suffix("").parts)
    # The package's own front is a room by itself; those of the rooms below belong to them.
    return name if name == "bugbot.__init__" else name.removesuffix(".__init__")


SOURCES = sorted(path for path in PY.rglob("*.py"))


@pytest.mark.parametrize("path", SOURCES, ids=[str(path.relative_to(PY)) for path in SOURCES])
def test_a_module_imports_only_what_its_room_may(path: Path) -> None:
    allowed = MAY_IMPORT[room_of(module_name(path))]
    assert forbidden(path.read_text(encoding="utf-8"), allowed) == []


def test_nobody_imports_the_bridge() -> None:
    assert not [room for room, may in MAY_IMPORT.items() if "bridge" in may and room != "bridge"]


def allowed_in_lessons(path: PurePosixPath) -> tuple[str, ...]:
    if path.parent.name == "pictures":
        return A_PICTURE
    return A_CHECK if path.name == "check.py" else A_PROGRAM


PROGRAMS = sorted(path.relative_to(LESSONS) for path in LESSONS.rglob("*.py"))


@pytest.mark.parametrize("path", PROGRAMS, ids=map(str, PROGRAMS))
def test_a_lessons_program_imports_only_what_a_learner_may(path: Path) -> None:
    source = (LESSONS / path).read_text(encoding="utf-8")
    try:
        found = forbidden(source, allowed_in_lessons(PurePosixPath(path)))
    except SyntaxError:
        assert "wrong" in path.parts, "only a wrong attempt may be unreadable"
        return
    assert found == []


@pytest.mark.parametrize(
    ("source", "room", "found"),
    [
        ("import math\nfrom bugbot.frames import MAT_CM", "mapping", []),
        ("from bugbot import frames, errors", "mapping", []),
        ("from bugbot import wait", "mapping", ["line 1: bugbot"]),
        (
            "def f():\n    from bugbot.sim.depth import BEAMS",
            "mapping",
            ["line 2: bugbot.sim.depth"],
        ),
        ("from bugbot import api", "bugbot.sim", ["line 1: bugbot.api"]),
        ("import bugbot.run", "bugbot.api", ["line 1: bugbot.run"]),
        ("import numpy.linalg", "bugbot.sim", ["line 1: numpy.linalg"]),
        ("import bridge", "grader", ["line 1: bridge"]),
        ("import bugbot.run.program, bugbot.sim.depth", "grader", []),
    ],
)
def test_a_wrong_arrow_is_seen(source: str, room: str, found: list[str]) -> None:
    assert forbidden(source, MAY_IMPORT[room]) == found


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("from bugbot import *\nimport bugbot, random\nimport numpy as np", []),
        ("from bugbot.sim import depth\nimport mapping\nfrom bugbot import frames", 3),
    ],
)
def test_a_program_that_looks_behind_the_scenes_is_seen(
    source: str, found: list[str] | int
) -> None:
    seen = forbidden(source, A_PROGRAM)
    assert seen == found or len(seen) == found


def test_a_module_without_a_room_is_seen() -> None:
    with pytest.raises(AssertionError, match="elsewhere belongs to no room"):
        room_of("elsewhere")
