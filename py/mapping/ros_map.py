"""Map files of the Robot Operating System: an image and a YAML file beside it.

May import: the standard library, `bugbot.errors`, `mapping.images`, `mapping.frontiers`,
`mapping.grid`, `mapping.map_yaml`, `mapping.ros_readers`.

A map is a `nav_msgs/OccupancyGrid`: whole numbers 0 (free) to 100 (occupied) and -1 (unknown),
row after row from the bottom, as our grids are. The image's first row is the TOP of the map.

Readers differ in what they make of a pixel, and the difference bites: grey 205, which every
writer uses for unknown, has p = 50/255 = 0.196. With free_thresh 0.25 it is read as free floor.
So what is written here has free_thresh 0.196, as nav2 does since 2025.

Their rules are in `ros_readers`, with where they come from. `tests/py/mapping/ros` has files with
what the real readers make of them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite

from bugbot.errors import WrongValueError, got
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.images import Image, read_image, write_pgm, write_png
from mapping.map_yaml import Mode, Reader, read_settings, settings_of
from mapping.ros_readers import UNKNOWN, cell_bytes

__all__ = [
    "FREE_THRESH",
    "OCCUPIED_THRESH",
    "UNKNOWN",
    "Mode",
    "Reader",
    "RosMap",
    "cells_of",
    "read",
    "write",
]

_OPAQUE = 255

OCCUPIED_THRESH = 0.65
FREE_THRESH = 0.196
"""Thresholds that keep grey 205 unknown for every reader."""

_FREE_GREY, _UNKNOWN_GREY, _OCCUPIED_GREY = 254, 205, 0


@dataclass(frozen=True)
class RosMap:
    """A map to be written, or one that was read.

    cells       width * height whole numbers, 0 to 100 or -1, row after row from the bottom
    resolution  side of a cell [m]
    origin      (x, y) of the lower left corner [m] and the map's turn [rad]
    """

    width: int
    height: int
    cells: tuple[int, ...]
    resolution: float
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        if min(self.width, self.height) < 1 or len(self.cells) != self.width * self.height:
            raise WrongValueError(
                f"RosMap wants {self.width} times {self.height} cells; it got {len(self.cells)}"
            )
        if not (self.resolution > 0 and isfinite(self.resolution)):
            raise WrongValueError(
                f"RosMap wants a resolution above 0 (m); it got {got(self.resolution)}"
            )
        if not all(isfinite(each) for each in self.origin):
            raise WrongValueError(f"RosMap wants an origin of numbers; it got {got(self.origin)}")

    @classmethod
    def of_states(cls, grid: Grid, states: Sequence[State]) -> RosMap:
        """Our map of the mat: the mat's lower left corner is the origin."""
        cells = tuple(int(each) for each in states)
        return cls(grid.across, grid.across, cells, grid.cell_cm / 100)


def read(text: str, image: bytes, reader: Reader = Reader.NAV2) -> RosMap:
    """The map in a YAML file's text and its image's bytes, by a reader's rules.

    Raises WrongValueError that names the line or says what is wrong with the image.
    """
    settings = read_settings(text, reader)
    pixels = read_image(image)
    cells = tuple(memoryview(cell_bytes(pixels, settings, reader)).cast("b"))
    return RosMap(pixels.width, pixels.height, cells, settings.resolution, settings.origin)


def cells_of(
    rows: Sequence[Sequence[int]], said: Mapping[str, object], reader: Reader = Reader.NAV2
) -> list[list[int]]:
    """What a reader makes of an image's greys and the settings beside it: rows from the bottom.

    rows  greys 0 to 255, the image's top row first
    said  the settings by their names, as they would stand in the YAML file

    Raises WrongValueError where the reader would refuse them.

    >>> said = {"image": "a.pgm", "resolution": 0.05, "origin": [0, 0, 0], "negate": 0}
    >>> said |= {"occupied_thresh": 0.65, "free_thresh": 0.196}
    >>> cells_of([[0, 205], [254, 254]], said)
    [[0, 0], [100, -1]]
    """
    settings = settings_of(said, reader)
    width = len(rows[0]) if rows else 0
    try:
        grey = bytes(grey for row in rows for grey in row)
    except (ValueError, TypeError):
        raise WrongValueError("an image's greys are whole numbers from 0 to 255") from None
    cells = memoryview(cell_bytes(Image(width, len(rows), grey), settings, reader)).cast("b")
    return [list(cells[start : start + width]) for start in range(0, len(cells), width)]


def write(
    a_map: RosMap, image_name: str, mode: Mode = Mode.TRINARY, *, png: bool | None = None
) -> tuple[str, bytes]:
    """The text of the YAML file and the bytes of the image.

    image_name  what the image will be called, as the YAML file names it
    png         PNG instead of PGM; usual for scale alone, which needs transparency
    """
    png = (mode is Mode.SCALE) if png is None else png
    if mode is Mode.SCALE and not png:
        raise WrongValueError("a map in scale mode wants a PNG file: a PGM has no transparency")
    pixels = {cell: _pixel(cell, mode) for cell in set(a_map.cells)}
    starts = reversed(range(0, len(a_map.cells), a_map.width))
    top_down = [cell for start in starts for cell in a_map.cells[start : start + a_map.width]]
    greys = bytes(pixels[cell][0] for cell in top_down)
    # Alpha only where it says something: some readers average it in.
    alpha = bytes(pixels[cell][1] for cell in top_down) if mode is Mode.SCALE else None
    image = Image(a_map.width, a_map.height, greys, alpha)
    x, y, yaw = map(_digits, a_map.origin)
    text = (
        f"image: {_name(image_name)}\n"
        f"mode: {mode}\n"
        f"resolution: {_digits(a_map.resolution)}\n"
        f"origin: [{x}, {y}, {yaw}]\n"
        "negate: 0\n"
        f"occupied_thresh: {OCCUPIED_THRESH}\n"
        f"free_thresh: {FREE_THRESH}\n"
    )
    return text, write_png(image) if png else write_pgm(image)


def _pixel(cell: int, mode: Mode) -> tuple[int, int]:
    """Grey and alpha of a cell."""
    unknown = not 0 <= cell <= 100
    if mode is Mode.RAW:
        return (255 if unknown else cell), _OPAQUE
    if mode is Mode.SCALE:
        return (127, 0) if unknown else (round(255 * (100 - cell) / 100), _OPAQUE)
    if unknown:
        return _UNKNOWN_GREY, _OPAQUE
    if cell <= round(100 * FREE_THRESH):
        return _FREE_GREY, _OPAQUE
    return (_OCCUPIED_GREY if cell >= round(100 * OCCUPIED_THRESH) else _UNKNOWN_GREY), _OPAQUE


def _digits(number: float) -> str:
    """As many digits as the number has; a point before an exponent, which YAML 1.1 wants."""
    text = repr(float(number)).removesuffix(".0")
    return text if "e" not in text or "." in text else text.replace("e", ".0e")


def _name(image_name: str) -> str:
    """In quotes, unless it is plain: #, brackets, a colon or a blank can mean something in YAML."""
    if not image_name:
        raise WrongValueError("write(a_map, image_name) wants a name for the image; it got ''")
    if re.fullmatch(r"[A-Za-z_][\w./-]*\.(?:pgm|png)", image_name, re.ASCII):
        return image_name
    return json.dumps(image_name, ensure_ascii=False)
