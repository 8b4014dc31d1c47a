"""The article's pictures are drawn, can be read on a phone, and show what the geometry says."""

from __future__ import annotations

import re
import runpy
from functools import cache
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest
from programs import LESSONS

FILES = sorted(LESSONS.glob("*/pictures/*.py"))
ARTICLE = LESSONS / "occupancy-grid-mapping" / "pictures"
WIDE = 340
NARROW, WIDE_LETTERS = " ijl.,:;'’|!tfr()", "mwMW%−+"


def ems(words):
    """About how long words are in a wide sans serif (DejaVu Sans), in sizes of the type."""
    return sum(0.36 if c in NARROW else 0.92 if c in WIDE_LETTERS else 0.63 for c in words)


@cache
def module(file):
    return SimpleNamespace(**runpy.run_path(str(file)))


@cache
def root(file):
    return ElementTree.fromstring(module(file).picture())


def of_kind(file, kind):
    return [each for each in root(file).iter() if kind in (each.get("class") or "").split()]


def named(file):
    return f"{file.parent.parent.name}-{file.stem}"


@pytest.mark.parametrize("file", FILES, ids=named)
def test_a_picture_fits_a_phone_and_describes_itself(file):
    _, _, width, _ = map(float, root(file).get("viewBox").split())
    assert width == WIDE, "a unit is a pixel on a phone, so that words are 12 pixels or more"
    title, desc = root(file).findtext("title"), root(file).findtext("desc")
    assert len(title) < 60
    assert len(desc) > 80
    assert not re.search(r"#[0-9a-f]{3}|style=|fill=", module(file).picture()), "classes alone"


@pytest.mark.parametrize("file", FILES, ids=named)
def test_nothing_sticks_out_of_a_picture(file):
    _, _, width, height = map(float, root(file).get("viewBox").split())
    for text in root(file).iter("text"):
        kinds = text.get("class").split()
        long = (12 if "small" in kinds else 13) * ems(text.text)
        start = float(text.get("x")) - long * (0.5 if "middle" in kinds else "end" in kinds)
        assert 0 <= float(text.get("y")) <= height, text.text
        assert start >= -2, text.text
        assert start + long <= width + 2, text.text
    for shape in root(file).iter("rect"):
        assert float(shape.get("x")) >= 0
        assert float(shape.get("x")) + float(shape.get("width")) <= width
        assert float(shape.get("y")) + float(shape.get("height")) <= height


# -- what they show -----------------------------------------------------------------


def test_half_cell_steps_leave_out_less_than_the_other_rules_do():
    steps = module(ARTICLE / "steps.py")
    crossed = steps.cells_crossed()
    half = set(steps.passed_by_steps(*steps.START, steps.ANGLE_DEG, steps.LENGTH_CM, steps.CELL_CM))
    whole = set(steps.whole_steps())
    line = set(
        steps.passed_by_bresenham(*steps.START, steps.ANGLE_DEG, steps.LENGTH_CM, steps.CELL_CM)
    )
    assert len(crossed - half) == 1, "one corner that is clipped"
    assert len(crossed - whole) > 3, "the speckles"
    assert len(crossed - line) > 3, "one cell thick"
    assert half | whole <= crossed
    # A cross is two lines.
    left_out = sum(len(crossed - cells) for cells in (half, whole, line))
    assert len(of_kind(ARTICLE / "steps.py", "missed")) == 2 * left_out


def test_a_straight_beam_goes_through_the_cells_one_can_count():
    steps = module(ARTICLE / "steps.py")
    dots = [float(each.get("cx")) for each in of_kind(ARTICLE / "steps.py", "step")]
    half, whole = int(steps.LENGTH_CM / 5), int(steps.LENGTH_CM / 10)
    assert len(dots) == half + whole, "one dot a step, none for Bresenham"


def test_one_reading_leaves_one_cell_unmarked_before_its_end():
    free = [float(each.get("x")) for each in of_kind(ARTICLE / "one-reading.py", "free")]
    (hit,) = of_kind(ARTICLE / "one-reading.py", "occupied")
    cell = float(hit.get("width"))
    assert float(hit.get("x")) - max(free) == pytest.approx(2 * cell)


def test_the_drifted_look_draws_the_wall_where_none_is():
    doubled = module(ARTICLE / "doubled-walls.py")
    _, y, width, _ = doubled.WALL
    first, second = doubled.occupied(0), doubled.occupied(doubled.DRIFT_DEG)
    assert {row for _, row in first} == {y // doubled.CELL_CM}
    assert len(first) == width / doubled.CELL_CM
    beside = [cell for cell in second if cell not in first]
    assert len(beside) > len(second) / 2


def test_the_frontier_has_one_region_worth_a_drive():
    assert len(of_kind(ARTICLE / "frontiers.py", "frontier")) == 7 + 1
    assert len(of_kind(ARTICLE / "frontiers.py", "chosen")) == 1
