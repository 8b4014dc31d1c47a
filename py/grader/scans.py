"""What the reference makes of a run's own scans, taken as they were or as a slip would.

May import: the standard library, `bugbot.frames`, `bugbot.trace`, `mapping`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import floor

from bugbot.frames import direction
from bugbot.trace import Trace
from mapping.beam import PassedBy, Weights, passed_by_steps
from mapping.grid import Grid
from mapping.mapper import Mapper

__all__ = ["Scan", "SeenAs", "evidence_at", "mapper_of", "scans_of", "touched"]

Beam = tuple[float, float, float, float, float]
"""x, y of the robot on the mat [cm], its heading, the beam's angle from straight ahead [degrees
clockwise], the reading [cm]."""

SeenAs = Callable[[float, float, float, float, float], Beam | None]
"""How a slip would take a beam: the five numbers it would go by, or None to leave it out."""


@dataclass(frozen=True, slots=True)
class Scan:
    """One look of the depth sensor, with the true pose it was taken from."""

    t: float
    x: float
    y: float
    heading: float
    beams: tuple[tuple[float, float], ...]


def scans_of(trace: Trace) -> list[Scan]:
    """The scans of a run in order; calls of distance() are scans of one beam."""
    return [
        Scan(t, x, y, heading, tuple(zip(flat[::2], flat[1::2], strict=True)))
        for _, t, x, y, heading, flat in (each for each in trace.events if each[0] == "scan")
    ]


def mapper_of(
    scans: Iterable[Scan],
    cell_cm: float = 5.0,
    weights: Weights = Weights(),  # noqa: B008 - it is frozen
    passed_by: PassedBy = passed_by_steps,
    seen_as: SeenAs | None = None,
    after: Callable[[float, Grid], None] = lambda _t, _grid: None,
) -> Mapper:
    """The reference mapper, fed with these scans; `after(t, grid)` is called after each."""
    mapper = Mapper(cell_cm, weights, passed_by)
    for scan in scans:
        for angle, reading in scan.beams:
            beam: Beam | None = (scan.x, scan.y, scan.heading, angle, reading)
            if seen_as is not None:
                beam = seen_as(scan.x, scan.y, scan.heading, angle, reading)
            if beam is not None and beam[4] >= 0.0:
                mapper.add_beam(beam[0], beam[1], beam[2] + beam[3], beam[4])
        after(scan.t, mapper.grid)
    return mapper


def evidence_at(
    scans: Iterable[Scan],
    x: float,
    y: float,
    cell_cm: float = 5.0,
    weights: Weights = Weights(),  # noqa: B008 - it is frozen
    passed_by: PassedBy = passed_by_steps,
    seen_as: SeenAs | None = None,
) -> list[tuple[float, float]]:
    """Time and log odds, at first and after each scan, of the cell that holds a point."""
    found: list[tuple[float, float]] = [(0.0, 0.0)]

    def note(t: float, grid: Grid) -> None:
        index = grid.index_at(x, y)
        if index is not None:
            found.append((t, grid.cells[index]))

    mapper_of(scans, cell_cm, weights, passed_by, seen_as, note)
    return found


def touched(scans: Iterable[Scan], grid: Grid) -> set[int]:
    """The cells that a beam of these scans may have spoken of, and those round them."""
    looks: dict[tuple[int, int, int, float], tuple[float, ...]] = {}
    for scan in scans:  # a robot that looks ten times a second looks at the same again and again
        for angle, reading in scan.beams:
            key = (round(scan.x), round(scan.y), round(scan.heading), angle)
            before = looks.get(key)
            if before is None or before[3] < reading:
                looks[key] = (scan.x, scan.y, scan.heading + angle, reading)
    across, cell_cm = grid.across, grid.cell_cm
    crossed = set()
    for x, y, angle, reading in looks.values():
        dx, dy = direction(angle)
        for step in range(floor(reading / cell_cm) + 2):
            column = floor((x + step * cell_cm * dx) / cell_cm)
            row = floor((y + step * cell_cm * dy) / cell_cm)
            crossed.add(row * (across + 2) + column)
    wide = across + 2
    around = [rows * wide + columns for rows in (-1, 0, 1) for columns in (-1, 0, 1)]
    grown = {cell + step for cell in crossed for step in around}
    return {
        index
        for index in range(len(grid.cells))
        if index // across * wide + index % across in grown
    }
