"""What the reference makes of a run's scans: one beam at a time, on cells counted by hand."""

from __future__ import annotations

import pytest

from grader.scans import Scan, beams_of, evidence_at, mapper_of
from mapping.beam import Weights, passed_by_bresenham


def beam(x: float, y: float, reading: float, t: float = 0.0, heading: float = 0.0) -> Scan:
    """A look with one beam, straight ahead."""
    return Scan(t, x, y, heading, ((0.0, reading),))


def test_beams_lie_on_the_mat_by_heading_and_angle_and_missing_readings_are_none() -> None:
    scan = Scan(0.0, 50, 60, 90.0, ((-10.0, 30.0), (10.0, -1.0)))
    assert list(beams_of([scan])) == [(50, 60, 80.0, 30.0)]


def test_the_reference_takes_each_beam_from_where_it_was_looked() -> None:
    mapper = mapper_of([beam(102.5, 42.5, 30)])
    grid = mapper.grid
    assert grid.cell_cm == 5
    wall, floor = grid.index_at(102.5, 72.5), grid.index_at(102.5, 62.5)
    assert wall is not None
    assert floor is not None
    assert grid.cells[wall] > 0 > grid.cells[floor]
    assert sum(value > 0 for value in grid.cells) == 1


@pytest.mark.parametrize(("reading", "known"), [(0.0, True), (0.5, True), (-1.0, False)])
def test_a_reading_of_nothing_is_a_reading_and_a_missing_one_is_none(
    reading: float, known: bool
) -> None:
    cells = mapper_of([beam(102.5, 42.5, reading)]).grid.cells
    assert any(cells) is known


def test_the_reference_passes_cells_as_it_is_told() -> None:
    slant = Scan(0.0, 102.5, 42.5, 0.0, ((20.0, 60.0),))
    by_steps = mapper_of([slant], 2.5).grid.cells
    by_bresenham = mapper_of([slant], 2.5, Weights(), passed_by_bresenham).grid.cells
    assert by_steps != by_bresenham


def test_the_evidence_for_a_cell_is_noted_after_each_scan() -> None:
    scans = [beam(102.5, 42.5, 30, t=1.0), beam(102.5, 42.5, 30, t=2.0)]
    found = evidence_at(scans, 102.5, 72.5)
    assert [t for t, _ in found] == [0.0, 1.0, 2.0]
    assert found[0][1] == 0 < found[1][1] < found[2][1]
    # Of the cell of 5 cm: the one above it is another.
    assert [value for _, value in evidence_at(scans, 102.5, 76)] == [0, 0, 0]
    assert evidence_at(scans, 250, 250) == [(0.0, 0.0)]
    unseen = evidence_at(scans, 102.5, 72.5, seen_as=lambda *_: None)
    assert [value for _, value in unseen] == [0, 0, 0]
