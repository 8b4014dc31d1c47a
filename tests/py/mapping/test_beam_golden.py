"""The beams that the page's own geometry is held to: tests/golden/beams.json, made here.

tests/unit/figures.spec.ts reads the same file. No beam runs along a line between cells: there the
last bit of a sine, which differs from one machine to another, would decide.
"""

import json
from itertools import product

from mapping.beam import (
    FAR_CM,
    clear_length,
    end_of_beam,
    end_of_hit,
    passed_by_bresenham,
    passed_by_steps,
)

STARTS = [(102.5, 41.3, 5), (13, 16, 10), (187.1, 93.7, 20)]
ANGLES = [0, 57.6, 90, 133.2, 180, -19.6875, -90, 301]
READINGS = [3, 48.9, 151.5, 200]


def whole_cell_steps(x, y, angle, length, cell):
    """What the walk would name with steps of a whole cell: every second look, whole steps only."""
    return passed_by_steps(x, y, angle, length, cell)[::2][: int(length / cell)]


def beam(x, y, angle, reading, cell):
    clear = clear_length(reading, cell)
    hit = end_of_hit(x, y, angle, reading)
    return {
        "x": x,
        "y": y,
        "angle": angle,
        "reading": reading,
        "cell": cell,
        "clear": clear,
        "hit": hit and [round(each, 6) for each in hit],
        "end": [round(each, 6) for each in end_of_beam(x, y, angle, clear)],
        "half": passed_by_steps(x, y, angle, clear, cell),
        "whole": whole_cell_steps(x, y, angle, clear, cell),
        "bresenham": passed_by_bresenham(x, y, angle, clear, cell),
    }


def test_the_beams_of_the_golden_file_have_not_changed(golden):
    beams = [
        beam(x, y, angle, reading, cell)
        for (x, y, cell), angle, reading in product(STARTS, ANGLES, READINGS)
    ]
    lines = ",\n".join(json.dumps(each, separators=(",", ":")) for each in beams)
    golden("beams.json", f'{{"far":{FAR_CM:g},"beams":[\n{lines}\n]}}\n')
