"""Every world has a ready program that maps it, ends by itself and makes a good map."""

from __future__ import annotations

import ast
import json
import re

import pytest
from programs import DEMOS, LESSONS, run, score_of

from bugbot import worlds

ENTRIES = json.loads((LESSONS / "lab" / "lab.json").read_text("utf-8"))
FILES = sorted({*DEMOS.glob("*.py"), *(LESSONS / "lab" / "programs").glob("*.py")})

KNOWN_AT_LEAST = {
    "post-and-shelf": 60,  # from one spot, with what the post and the shelf hide
    "wall-ahead": 12,  # one look ahead, never round
    "doorway": 97,
    "empty": 97,
    "cluttered-room": 90,  # the inside of the furniture is 13 % of the mat
    "small-maze": 97,
}


def test_every_world_has_one_ready_program():
    assert sorted(entry["world"] for entry in ENTRIES) == worlds.names()
    assert all(entry["title"].strip() for entry in ENTRIES)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry["world"])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_ready_program_ends_by_itself_with_a_good_map(entry, seed):
    world = entry["world"]
    trace, outcome = run((LESSONS / "lab" / entry["program"]).resolve(), world, seed)
    assert outcome["status"] == "finished", outcome["message"]
    assert outcome["console"] == ""
    assert outcome["seconds"] < 200
    assert list(trace.of_kind("bump")) == [], "it drives into nothing"
    result = score_of(outcome, world)
    assert result.known_percent >= KNOWN_AT_LEAST[world]
    assert result.wrong_walls_percent <= 2
    assert len(result.wrong_floor) <= 2


# -- the texts: what the editor's sliders and the reader count on ---------------------

NUMBER = re.compile(r"^([A-Z_]+) = (-?[\d.]+)  # .* \((-?[\d.]+) to (-?[\d.]+)\)$", re.M)


def named(file):
    return file.stem


@pytest.mark.parametrize("file", FILES, ids=named)
def test_a_program_imports_the_robot_and_math_alone(file):
    imported = []
    for node in ast.walk(ast.parse(file.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            imported += [each.name for each in node.names]
        elif isinstance(node, ast.ImportFrom):
            imported.append(node.module)
    assert sorted(imported) == ["bugbot", "math"]


@pytest.mark.parametrize("file", FILES, ids=named)
def test_the_numbers_to_change_lie_within_their_ranges(file):
    text = file.read_text("utf-8")
    section = text.split("# Numbers to change\n")[1].split("\n\n")[0]
    numbers = NUMBER.findall(section)
    assert len(numbers) == len(section.splitlines()), "each has a range in its comment"
    for name, value, low, high in numbers:
        assert float(low) <= float(value) <= float(high), name


@pytest.mark.parametrize(
    ("demo", "name", "value"),
    [
        ("demo-1-from-one-spot", "L_FREE", 0),
        ("demo-1-from-one-spot", "CELL", 20),
        ("demo-2-adding-up-evidence", "L_MAX", 100),
        ("demo-2-adding-up-evidence", "L_FREE", -0.85),
        ("demo-3-wrong-pose", "DRIFT", 1),
        ("demo-3-wrong-pose", "DRIFT", 0.2),
        ("demo-4-frontiers", "MIN_REGION", 1),
        ("demo-4-frontiers", "OCC_P", 0.95),
    ],
)
def test_an_experiments_number_is_there_and_in_its_range(demo, name, value):
    numbers = {each[0]: each[2:] for each in NUMBER.findall((DEMOS / f"{demo}.py").read_text())}
    low, high = numbers[name]
    assert float(low) <= value <= float(high)


@pytest.mark.parametrize("file", FILES, ids=named)
@pytest.mark.parametrize("end", ["low", "high"])
def test_the_numbers_may_be_dragged_to_the_ends_of_their_ranges(file, end):
    world = next((each["world"] for each in ENTRIES if each["program"].endswith(file.name)), None)
    numbers = {
        name: low if end == "low" else high
        for name, _, low, high in NUMBER.findall(file.read_text("utf-8"))
    }
    outcome = run(file, world or "post-and-shelf", 1, **numbers)[1]
    assert outcome["status"] == "finished", outcome["message"]
