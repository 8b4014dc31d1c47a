"""What is fuzzed: each reader with good files to begin from, and the errors it may raise."""

from __future__ import annotations

import json
import shutil
from base64 import b64encode
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random
from tempfile import mkdtemp
from typing import Any

from bugbot import worlds
from bugbot.errors import WrongValueError
from bugbot.run import run_program
from bugbot.trace import Trace, TraceError
from bugbot.worlds import WorldError
from grader.lesson import CourseError, lesson_at
from grader.traces import MalformedError, trace_from
from mapping import ros_map
from mapping.map_yaml import Mode

from .mutate import damaged, damaged_json

ROOT = Path(__file__).resolve().parents[2]


_PROGRAM = """
from bugbot import *
left(30)
for look in range(3):
    scan()
    draw("free", [(100, 100), (look, 105)], "blue", "squares", 5)
    plot("look", look)
    print("looked", look)
    wait(0.1)
led("red")
beep(440)
"""


@dataclass(frozen=True)
class Target:
    """`read` is given a damaged case; it may raise only `allowed`. Returns whether it was taken."""

    name: str
    damage: Callable[[Random], Any]
    read: Callable[[Any], bool]
    allowed: tuple[type[Exception], ...]


def _text(data: bytes) -> str:
    return data.decode("utf-8", "replace")


def _trace() -> Target:
    whole = (ROOT / "tests/golden/every-kind.trace").read_text(encoding="utf-8")

    def damage(random: Random) -> str:
        if random.random() < 0.5:
            return _text(damaged(whole.encode(), random))
        lines = whole.splitlines(keepends=True)
        at = random.randrange(len(lines))
        lines[at] = damaged_json(lines[at], random) + "\n"
        return "".join(lines)

    def read(text: str) -> bool:
        Trace.load(text.splitlines(keepends=True))
        return True

    return Target("trace file (Python)", damage, read, (TraceError,))


def _claimed_trace() -> Target:
    trace = run_program(_PROGRAM, "empty", 1)
    claim = json.dumps(
        {
            "events": json.dumps(trace.events),
            "points": b64encode(trace.points.tobytes()).decode(),
        }
    )

    def damage(random: Random) -> Any:
        data = json.loads(claim)
        if random.random() < 0.7:
            data["events"] = damaged_json(data["events"], random)
        else:
            data = json.loads(damaged_json(claim, random))
        return data

    def read(data: Any) -> bool:
        trace_from(data, trace.header["world"], 1, 600.0)
        return True

    return Target("a performer's claim", damage, read, (MalformedError,))


def _world() -> Target:
    files = sorted((ROOT / "py/bugbot/worlds").glob("*.json"))
    folder = Path(mkdtemp(prefix="fuzz-world-"))

    def damage(random: Random) -> bytes:
        data = random.choice(files).read_bytes()
        if random.random() < 0.5:
            return damaged(data, random)
        return damaged_json(data.decode(), random).encode("utf-8", "surrogatepass")

    def read(data: bytes) -> bool:
        path = folder / "world.json"
        path.write_bytes(data)
        worlds.load(path)
        return True

    return Target("world file", damage, read, (WorldError,))


def _lesson() -> Target:
    whole = ROOT / "lessons/u8-1-a-map-of-cells"
    folder = Path(mkdtemp(prefix="fuzz-lesson-"))
    names = [path.relative_to(whole) for path in sorted(whole.rglob("*")) if path.is_file()]
    often = [Path("lesson.json")] * len(names)

    def damage(random: Random) -> tuple[Path, bytes]:
        name = random.choice([*names, *often])
        data = (whole / name).read_bytes()
        if name.suffix == ".json" and random.random() < 0.6:
            return name, damaged_json(data.decode(), random).encode("utf-8", "surrogatepass")
        return name, damaged(data, random)

    def read(case: tuple[Path, bytes]) -> bool:
        name, data = case
        copy = folder / "u8-1-a-map-of-cells"
        if not copy.exists():
            shutil.copytree(whole, copy)
        (copy / name).write_bytes(data)
        try:
            return not lesson_at(copy).faults
        finally:
            shutil.copyfile(whole / name, copy / name)

    return Target("lesson folder (Python)", damage, read, (CourseError,))


def _ros_map() -> Target:
    cells = tuple([-1, 0, 100, 50] * 6)
    small = ros_map.RosMap(6, 4, cells, 0.05, (0.5, -1.0, 0.0))
    files = [
        ros_map.write(small, "map.png" if png else "map.pgm", mode, png=png)
        for mode in Mode
        for png in (True, False)
        if png or mode is not Mode.SCALE
    ]

    def damage(random: Random) -> tuple[str, bytes]:
        text, image = random.choice(files)
        if random.random() < 0.5:
            return _text(damaged(text.encode(), random)), image
        return text, damaged(image, random)

    def read(case: tuple[str, bytes]) -> bool:
        # What can be read has cells of a map, whatever was damaged.
        assert all(-1 <= cell <= 100 for cell in ros_map.read(*case).cells)
        return True

    return Target("ROS map", damage, read, (WrongValueError,))


def all_targets() -> list[Target]:
    """Every reader there is."""
    return [_trace(), _claimed_trace(), _world(), _lesson(), _ros_map()]
