"""What beams say of cells, counted by hand on cells of 10 cm."""

from __future__ import annotations

import pytest

from mapping.beam import passed_by_bresenham, passed_by_steps
from mapping.evidence import Beam, Evidence
from mapping.frontiers import State, known_states
from mapping.grid import Grid
from mapping.mapper import Mapper

F, O, U = State.FREE, State.OCCUPIED, State.UNKNOWN  # noqa: E741 - as maps are drawn


def seen(*beams: Beam) -> Evidence:
    return Evidence(Grid(10), beams)


def cells_of(counts: list[int]) -> list[tuple[int, int]]:
    """(column, row) of the cells that count something."""
    return [(index % 20, index // 20) for index, count in enumerate(counts) if count]


@pytest.mark.parametrize(
    ("beam", "crossed", "ended"),
    [
        ((105, 105, 0, 28), [(10, 10), (10, 11), (10, 12)], [(10, 13)]),
        ((105, 105, 180, 28), [(10, 8), (10, 9), (10, 10)], [(10, 7)]),
        ((105, 105, 90, 12), [(10, 10)], [(11, 10)]),
        ((105, 105, 270, 3), [], [(10, 10)]),  # it ends where it began
        ((102, 105, 45, 14), [(10, 10), (10, 11)], [(11, 11)]),  # first over the upper side
        ((108, 105, 45, 14), [(10, 10), (11, 10)], [(11, 11)]),
        ((5, 185, 0, 12), [(0, 18)], [(0, 19)]),
        ((5, 185, 0, 16), [(0, 18), (0, 19)], []),  # beyond the mat is no cell
        ((5, 5, 0, 200), [(0, row) for row in range(18)], []),  # nothing found: up to 170 cm
        ((5, 5, 0, 170), [(0, row) for row in range(18)], []),
        ((5, 5, 0, 169), [(0, row) for row in range(17)], [(0, 17)]),
    ],
)
def test_a_beam_crosses_cells_and_ends_in_one(
    beam: Beam, crossed: list[tuple[int, int]], ended: list[tuple[int, int]]
) -> None:
    found = seen(beam)
    assert cells_of(found.crossed) == crossed
    assert cells_of(found.ended) == ended


def test_three_rules_are_added_up() -> None:
    # Straight up from the middle of a cell: 28 cm, so clear up to 18.
    found = seen((105, 105, 0, 28))
    column = [(found.low[row * 20 + 10], found.high[row * 20 + 10]) for row in range(10, 15)]
    expected = [
        (-0.4, -0.4),  # one step of half a cell; once
        (-0.8, -0.4),  # two steps; once
        (-0.4, 0.0),  # 15 to 25 cm, of which 18 are clear: once by both, a step at 15 by ...
        (0.85, 0.85),  # the hit
        (0.0, 0.0),
    ]
    assert column[0] == expected[0]
    assert column[1] == expected[1]
    assert column[3:] == expected[3:]
    # Steps at 0, 5 and 10: int(18 / 5) are three. The third cell begins at 15 cm: no step there.
    assert column[2] == expected[2]


def test_sums_are_clamped_as_they_are_added() -> None:
    found = seen(*[(105.0, 105.0, 0.0, 28.0)] * 50)
    assert min(found.low) == -8
    assert max(found.high) == 8
    turned = seen(*[(105.0, 105.0, 0.0, 28.0)] * 50, *[(105.0, 105.0, 0.0, 60.0)] * 41)
    assert turned.high[13 * 20 + 10] < -8 + 0.85


def test_support_is_one_rules_word_and_backing_every_rules() -> None:
    found = seen(*[(105.0, 105.0, 0.0, 28.0)] * 4)
    near, before, hit, behind = (row * 20 + 10 for row in (11, 12, 13, 14))
    assert found.supports(near, F)
    assert found.backs(near, F)
    assert found.supports(before, F)
    assert not found.backs(before, F)
    assert found.supports(hit, O)
    assert found.backs(hit, O)
    assert not found.supports(hit, F)
    assert not found.supports(near, O)
    assert not found.supports(behind, O)
    assert found.supports(behind, U)
    # Beyond how much, is for the asker to say: four passes, once each, are -1.6.
    assert not found.backs(near, F, known=1.61)


def test_what_no_beam_says_is_impossible_and_beside_a_beam_it_may_be_said() -> None:
    found = seen(*[(105.0, 105.0, 0.0, 28.0)] * 4)
    assert found.allows(11 * 20 + 11, F)  # beside the beam
    assert not found.allows(11 * 20 + 12, F)
    assert found.allows(11 * 20 + 12, F, reach=2)
    assert found.allows(14 * 20 + 10, O)  # behind the hit: noise may have put it there
    assert not found.allows(15 * 20 + 10, O)
    assert not found.allows(13 * 20 + 10, F)  # the hit's own cell
    assert not found.allows(11 * 20 + 10, O)  # plain floor
    assert found.allows(0, U)
    # In a corner there are fewer cells to look at, and none of the other side's.
    assert not seen((195.0, 5.0, 0.0, 28.0)).allows(20, F)


def test_plain_is_what_all_rules_say_by_a_margin() -> None:
    found = seen(*[(105.0, 105.0, 0.0, 28.0)] * 6)
    plain = [found.plain(row * 20 + 10) for row in range(10, 15)]
    assert plain == [F, F, U, O, U]
    # A single hit takes the plainness from a cell of floor.
    once = seen(*[(105.0, 105.0, 0.0, 28.0)] * 9, (105.0, 85.0, 0.0, 30.0))
    assert once.plain(11 * 20 + 10) is U


@pytest.mark.parametrize("passed_by", [passed_by_steps, passed_by_bresenham])
def test_the_reference_is_supported_by_the_evidence_that_it_was_made_of(passed_by: object) -> None:
    beams = [
        (102.0 + turn % 7, 96.0 + turn % 5, turn * 7.0, 30.0 + turn * 13 % 90)
        for turn in range(400)
    ]
    mapper = Mapper(5, passed_by=passed_by)  # type: ignore[arg-type]
    for beam in beams:
        mapper.add_beam(*beam)
    states = known_states(mapper.grid.cells)
    found = Evidence(Grid(5), beams)
    known = [index for index, state in enumerate(states) if state is not U]
    unsupported = [each for each in known if not found.supports(each, states[each])]
    assert len(known) > 300
    assert len(unsupported) <= (0 if passed_by is passed_by_steps else len(known) // 20)
