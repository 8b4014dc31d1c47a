"""Map files of the Robot Operating System: an image and a YAML file beside it.

May import: the standard library, `bugbot.errors`, `mapping.images`, `mapping.frontiers`,
`mapping.grid`,
`mapping.map_yaml`.

A map is a `nav_msgs/OccupancyGrid`: whole numbers 0 (free) to 100 (occupied) and -1 (unknown),
row after row from the bottom, as our grids are. The image's first row is the TOP of the map.

Readers differ in what they make of a pixel, and the difference bites: grey 205, which every
writer uses for unknown, has p = 50/255 = 0.196. With free_thresh 0.25 it is read as free floor.
So what is written here has free_thresh 0.196, as nav2 does since 2025.

Where it comes from (behaviour, restated):
  nav2_map_server/src/map_io.cpp, ros-navigation/navigation2 (pull requests 5071 and 5278, 2025)
  map_server/src/image_loader.cpp and map_saver.cpp, ros-planning/navigation, noetic
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from math import isfinite

from bugbot.errors import WrongValueError, got
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.images import Image, read_image, write_pgm, write_png
from mapping.map_yaml import Mode, Settings, read_settings

__all__ = ["FREE_THRESH", "OCCUPIED_THRESH", "UNKNOWN", "Mode", "Reader", "RosMap", "read", "write"]

UNKNOWN = -1

_OPAQUE = 255

OCCUPIED_THRESH = 0.65
FREE_THRESH = 0.196
"""Thresholds that keep grey 205 unknown for every reader."""

_FREE_GREY, _UNKNOWN_GREY, _OCCUPIED_GREY = 254, 205, 0


class Reader(StrEnum):
    """Whose rules a file is read by."""

    NAV2 = "nav2"
    """Since April 2025: a threshold itself counts, any transparency is unknown."""
    NAV2_2024 = "nav2 before 2025"
    ROS1 = "ros 1"


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

    @classmethod
    def of_states(cls, grid: Grid, states: Sequence[State]) -> RosMap:
        """Our map of the mat: the mat's lower left corner is the origin."""
        cells = tuple(int(each) for each in states)
        return cls(grid.across, grid.across, cells, grid.cell_cm / 100)


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
    greys = bytearray()
    alphas = bytearray()
    for row in reversed(range(a_map.height)):
        for cell in a_map.cells[row * a_map.width : (row + 1) * a_map.width]:
            grey, opacity = _pixel(cell, mode)
            greys.append(grey)
            alphas.append(opacity)
    # Alpha only where it says something: some readers average it in.
    alpha = bytes(alphas) if mode is Mode.SCALE else None
    image = Image(a_map.width, a_map.height, bytes(greys), alpha)
    x, y, yaw = a_map.origin
    text = (
        f"image: {image_name}\n"
        f"mode: {mode}\n"
        f"resolution: {a_map.resolution:g}\n"
        f"origin: [{x:g}, {y:g}, {yaw:g}]\n"
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


def read(text: str, image: bytes, reader: Reader = Reader.NAV2) -> RosMap:
    """The map in a YAML file's text and its image's bytes, by a reader's rules.

    Raises WrongValueError that names the line or says what is wrong with the image.
    """
    settings = read_settings(text)
    pixels = read_image(image)
    rule = _RULES[reader]
    cells: list[int] = []
    for row in reversed(range(pixels.height)):
        span = slice(row * pixels.width, (row + 1) * pixels.width)
        alphas = [None] * pixels.width if pixels.alpha is None else pixels.alpha[span]
        pairs = zip(pixels.grey[span], alphas, strict=True)
        cells += [rule(grey, alpha, settings) for grey, alpha in pairs]
    return RosMap(pixels.width, pixels.height, tuple(cells), settings.resolution, settings.origin)


def _by_nav2(grey: int, alpha: int | None, settings: Settings) -> int:
    if settings.mode is Mode.RAW:
        return grey if grey <= 100 else UNKNOWN
    if alpha is not None and alpha < _OPAQUE:
        return UNKNOWN
    p = _share(grey, settings)
    if p >= settings.occupied:
        return 100
    if p <= settings.free:
        return 0
    return _between(p, settings) if settings.mode is Mode.SCALE else UNKNOWN


def _by_nav2_2024(grey: int, alpha: int | None, settings: Settings) -> int:
    if settings.mode is Mode.RAW:
        return grey if grey <= 100 else UNKNOWN
    if settings.mode is Mode.SCALE and alpha is not None and alpha < _OPAQUE:
        return UNKNOWN
    p = _share(_averaged(grey, alpha, settings), settings)
    if p > settings.occupied:
        return 100
    if p < settings.free:
        return 0
    return _between(p, settings) if settings.mode is Mode.SCALE else UNKNOWN


def _by_ros1(grey: int, alpha: int | None, settings: Settings) -> int:
    if settings.mode is Mode.RAW:
        value = 255 - grey if settings.negate else grey
        return value - 256 if value > 127 else value  # an int8: 255 is -1
    p = _share(int(_averaged(grey, alpha, settings)), settings)
    if p > settings.occupied:
        return 100
    if p < settings.free:
        return 0
    if settings.mode is Mode.TRINARY or alpha == 0:
        return UNKNOWN
    return int(1 + 98 * (p - settings.free) / (settings.occupied - settings.free))


def _averaged(grey: int, alpha: int | None, settings: Settings) -> float:
    """Older readers average alpha in as a fourth colour, in trinary mode."""
    if alpha is None or settings.mode is not Mode.TRINARY:
        return grey
    return (3 * grey + alpha) / 4


_RULES = {Reader.NAV2: _by_nav2, Reader.NAV2_2024: _by_nav2_2024, Reader.ROS1: _by_ros1}


def _share(grey: float, settings: Settings) -> float:
    """How occupied a grey says a cell is, 0 to 1: dark is occupied unless negated."""
    return grey / 255 if settings.negate else (255 - grey) / 255


def _between(p: float, settings: Settings) -> int:
    return round(100 * (p - settings.free) / (settings.occupied - settings.free))
