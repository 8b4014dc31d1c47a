"""What the reference makes of a run's own scans, taken as they were or as a slip would.

May import: the standard library, `bugbot.trace`, `mapping`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from bugbot.trace import Trace
from mapping.beam import PassedBy, Weights, passed_by_steps
from mapping.evidence import Beam
from mapping.grid import Grid
from mapping.mapper import Mapper

__all__ = ["Scan", "SeenAs", "beams_of", "evidence_at", "mapper_of", "scans_of"]

Seen = tuple[float, float, float, float, float]
"""x, y of the robot on the mat [cm], its heading, the beam's angle from straight ahead [degrees
clockwise], the reading [cm]."""

SeenAs = Callable[[float, float, float, float, float], Seen | None]
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
            beam: Seen | None = (scan.x, scan.y, scan.heading, angle, reading)
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


def beams_of(scans: Iterable[Scan]) -> Iterator[Beam]:
    """The beams of these scans, as they lie on the mat."""
    for scan in scans:
        for angle, reading in scan.beams:
            if reading >= 0.0:
                yield scan.x, scan.y, scan.heading + angle, reading
