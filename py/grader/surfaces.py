"""Where the beams of a run really met something, whatever they read.

May import: the standard library, `bugbot.frames`, `bugbot.sim`, `bugbot.worlds`, `grader.scans`,
`mapping.beam`, `mapping.grid`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from bugbot.frames import MAT_CM
from bugbot.sim.depth import AHEAD, BEAMS, distances
from bugbot.sim.world import boxes_of
from bugbot.worlds import World
from grader.scans import Scan
from mapping.beam import FAR_CM, end_of_beam
from mapping.grid import Grid

__all__ = ["surfaces_met"]

_INSIDE_CM = 1e-6


def surfaces_met(
    world: World, scans: Iterable[Scan], grid: Grid, far_cm: float = FAR_CM
) -> Counter[int]:
    """How many beams met a surface in each cell, nearer than `far_cm`, by the cell's index."""
    boxes = boxes_of(world)
    met: Counter[int] = Counter()
    for scan in scans:
        beams = AHEAD if len(scan.beams) == 1 else BEAMS
        for (angle, _, _), cm in zip(
            beams, distances(boxes, scan.x, scan.y, scan.heading, beams), strict=True
        ):
            if cm < far_cm:
                x, y = end_of_beam(scan.x, scan.y, scan.heading + angle, cm)
                index = grid.index_at(_on_the_mat(x), _on_the_mat(y))
                if index is not None:
                    met[index] += 1
    return met


def _on_the_mat(at: float) -> float:
    return min(MAT_CM - _INSIDE_CM, max(0.0, at))
