"""The reference explorer on a few made mats; `npm run explore` has it on all of them."""

from __future__ import annotations

import pytest
from explore import SOLUTION, explore_all, table
from mats import KINDS, START, floor_cells, mat

from bugbot.frames import ROBOT_RADIUS_CM

CRASHES = "from bugbot import *\nforward(20, distance=5)\n1 / 0\n"
STOPS_AT_ONCE = (
    "from bugbot import *\n"
    'draw("free", [(102.5, 22.5)], "blue", "squares", 5)\n'
    'draw("occupied", [], "black", "squares", 5)\nscan()\n'
)


def test_the_explorer_comes_to_an_end_with_a_reason_and_a_good_map():
    runs = explore_all([0, 1, 3], [1], SOLUTION.read_text("utf-8"))
    assert [run.kind for run in runs] == ["rooms", "clutter", "screens"]
    for run in runs:
        assert run.passed, run
        assert run.of_floor > 90, run
        assert run.wrong < 3, run
        assert run.why


def test_a_crash_and_a_missing_reason_are_told():
    (crashed,) = explore_all([1], [1], CRASHES, processes=1)
    assert not crashed.passed
    assert crashed.ended == "fault"
    (silent,) = explore_all([1], [1], STOPS_AT_ONCE, processes=1)
    assert not silent.passed
    assert "fault" in table([crashed, silent])


@pytest.mark.parametrize("number", range(len(KINDS)))
def test_a_mat_is_always_the_same_and_the_robot_has_room_at_its_start(number):
    world = mat(number)
    assert world == mat(number)
    assert (world.start.x, world.start.y) == START
    assert min(each.gap(*START) for each in world.obstacles) > ROBOT_RADIUS_CM
    cells = floor_cells(world)
    assert (20, 5) in cells
    assert len(cells) > 1000
