"""What each reader of ROS maps makes of a pixel, and where two of them part.

May import: the standard library, `bugbot.errors`, `mapping.image`, `mapping.map_yaml`.

p says how occupied a pixel is: (255 - grey) / 255, or grey / 255 if negate is set.

    nav2              p <= free_thresh: free; p >= occupied_thresh: occupied; not opaque: unknown
    nav2 before 2025  p > occupied_thresh: occupied; p < free_thresh: free
    ROS 1             the same; in both of these alpha counts as a fourth colour in trinary mode

These are the rules as the readers' documents have them, in numbers of double precision. The real
readers depart from them in places, and where the page's reader, nav2, does, `doubts` tells:

- nav2 works p out in numbers of 24 bits, so a grey whose p is a threshold may fall on its other
  side, and between the thresholds 37.5 may be 37 or 38
- nav2 turns colours into grey by luma (0.299 red, 0.587 green, 0.114 blue); documents say the mean
- nav2 before 2025 gets alpha wrong in PNG files of grey and alpha (scale mode)
- ROS 1 takes blue for alpha in RGB files (scale mode), and the number of a colour for the colour in
  those with a palette; it reads no PGM of 16 bits, and a PBM as all occupied

Where it comes from (behaviour, restated):
  nav2_map_server/src/map_io.cpp, ros-navigation/navigation2 (pull requests 5071 and 5278, 2025)
  map_server/src/image_loader.cpp and map_saver.cpp, ros-planning/navigation, noetic
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator
from functools import partial
from typing import Literal

from bugbot.errors import counted
from mapping.image import Image
from mapping.map_yaml import Mode, Reader, Settings

__all__ = ["UNKNOWN", "cell_bytes", "doubts"]

UNKNOWN = -1

_OPAQUE = 255
_UNKNOWN_GREY = 205

Rule = Callable[[float, "int | None", Settings], int]
"""The cell for a shade (0 to 255, a mean need not be whole) and alpha, or None."""


def cell_bytes(image: Image, settings: Settings, reader: Reader = Reader.NAV2) -> bytes:
    """A byte for each cell, row after row from the bottom; as a signed number, -1 is unknown."""
    cells = _translated(image, partial(_cell, _RULES[reader], settings), reader)
    if image.height == 1:
        return cells
    width = image.width
    return b"".join(cells[at : at + width] for at in range(len(cells) - width, -1, -width))


def _cell(rule: Rule, settings: Settings, shade: float, alpha: int | None) -> int:
    return rule(shade, alpha, settings) & 255


def _translated(image: Image, cell: Callable[[float, int | None], int], reader: Reader) -> bytes:
    """The cell of each pixel, in the order of the pixels. Each kind of pixel is asked for once."""
    alpha, colours = image.alpha, image.colours
    if colours and reader is Reader.NAV2:
        colours = None  # it works with greys of 8 bits
    if alpha is not None and alpha.count(alpha[:1]) == len(alpha) and not colours:
        return image.grey.translate(bytes(cell(grey, alpha[0]) for grey in range(256)))
    if alpha is None and not colours:
        return image.grey.translate(bytes(cell(grey, None) for grey in range(256)))
    if not colours:
        pixels = _packed([image.grey, alpha or b""], "H")
        table = {
            each: cell(grey, clear)
            for each in set(pixels)
            for grey, clear in [struct.pack("=H", each)]
        }
    else:
        pixels = _packed([*colours, *([] if alpha is None else [alpha])], "I")
        table = {}
        for each in set(pixels):
            *rgb, clear = struct.pack("=I", each)
            table[each] = cell(sum(rgb) / 3, None if alpha is None else clear)
    return bytes(map(table.__getitem__, pixels))


def _packed(planes: list[bytes], code: Literal["H", "I"]) -> memoryview[int]:
    """One number for each pixel, of a byte of each plane in this order in memory."""
    step = struct.calcsize(f"={code}")
    mixed = bytearray(step * len(planes[0]))
    for i, plane in enumerate(planes):
        mixed[i::step] = plane
    return memoryview(mixed).cast(code)


# -- rules -------------------------------------------------------------------------


def _by_nav2(grey: float, alpha: int | None, settings: Settings) -> int:
    if settings.mode is Mode.RAW:
        return int(grey) if grey <= 100 else UNKNOWN
    if alpha is not None and alpha < _OPAQUE:
        return UNKNOWN
    p = _share(grey, settings)
    if p <= settings.free:  # of thresholds that cross, this one wins
        return 0
    if p >= settings.occupied:
        return 100
    return _between(p, settings) if settings.mode is Mode.SCALE else UNKNOWN


def _by_nav2_2024(grey: float, alpha: int | None, settings: Settings) -> int:
    if settings.mode is Mode.RAW:
        return round(grey) if grey <= 100 else UNKNOWN
    if settings.mode is Mode.SCALE and alpha is not None and alpha < _OPAQUE:
        return UNKNOWN
    bright = _averaged(grey, alpha, settings) / 255
    p = bright if settings.negate else 1 - bright
    if p > settings.occupied:
        return 100
    if p < settings.free:
        return 0
    room = settings.occupied - settings.free
    if settings.mode is not Mode.SCALE or room == 0:
        return UNKNOWN
    return round((p - settings.free) / room * 100)


def _by_ros1(grey: float, alpha: int | None, settings: Settings) -> int:
    if settings.mode is Mode.RAW:
        value = int(255 - grey if settings.negate else grey)
        return value - 256 if value > 127 else value  # an int8: 255 is -1
    p = _share(_averaged(grey, alpha, settings), settings)
    if p > settings.occupied:
        return 100
    if p < settings.free:
        return 0
    if settings.mode is Mode.TRINARY or alpha == 0:
        return UNKNOWN
    if settings.occupied == settings.free:
        return UNKNOWN
    return int(1 + 98 * (p - settings.free) / (settings.occupied - settings.free))


def _averaged(grey: float, alpha: int | None, settings: Settings) -> float:
    """Older readers average alpha in as a fourth colour, in trinary mode."""
    if alpha is None or settings.mode is not Mode.TRINARY:
        return grey
    return (3 * grey + alpha) / 4


_RULES: dict[Reader, Rule] = {
    Reader.NAV2: _by_nav2,
    Reader.NAV2_2024: _by_nav2_2024,
    Reader.ROS1: _by_ros1,
}


def _share(grey: float, settings: Settings) -> float:
    """How occupied a grey says a cell is, 0 to 1: dark is occupied unless negated."""
    return grey / 255 if settings.negate else (255 - grey) / 255


def _between(p: float, settings: Settings) -> int:
    """0 to 100, where p lies between the thresholds; unknown where they leave nothing between."""
    room = settings.occupied - settings.free
    return UNKNOWN if room <= 0 else round(100 * (p - settings.free) / room)


# -- doubts ------------------------------------------------------------------------


def doubts(image: Image, settings: Settings) -> list[str]:
    """What somebody should know of a map that nav2's rules have read: sentences without a stop."""
    return [
        *image.doubts,
        *_doubtful_settings(image, settings),
        *_doubtful_colours(image, settings),
    ]


def _doubtful_settings(image: Image, settings: Settings) -> Iterator[str]:
    if settings.mode is Mode.RAW:
        return
    free, occupied = settings.free, settings.occupied
    if free > occupied:
        yield (
            f"free_thresh ({free:g}) is above occupied_thresh ({occupied:g}), so no cell is unknown"
        )
    for name, value in (("free_thresh", free), ("occupied_thresh", occupied)):
        if not 0 <= value <= 1:
            yield f"{name} is {value:g}, but a threshold is a probability, 0 to 1"
    count = image.grey.count(_UNKNOWN_GREY)
    cell = _by_nav2(_UNKNOWN_GREY, None, settings)
    if count and cell in (0, 100):
        p = _share(_UNKNOWN_GREY, settings)
        name, value = ("free_thresh", free) if cell == 0 else ("occupied_thresh", occupied)
        yield (
            f"with {name} {value:g} the grey 205, which most programs write for unknown, is read "
            f"as {'free floor' if cell == 0 else 'occupied'} (its p is {p:.3f}): "
            f"{counted(count, 'cell')}. "
            + (
                "A free_thresh of 0.196 keeps them unknown"
                if not settings.negate
                else "negate: 0 is usual for such an image"
            )
        )


def _doubtful_colours(image: Image, settings: Settings) -> Iterator[str]:
    if settings.mode is Mode.RAW:
        return
    used = [grey for grey in range(256) if grey in image.grey]
    parted = [
        (grey, ours, theirs)
        for grey in used
        for ours in [_by_nav2(grey, None, settings)]
        for theirs in [_in_24_bits(grey, settings)]
        if ours != theirs
    ]
    if parted:
        grey, ours, theirs = parted[0]
        more = f", and {counted(len(parted) - 1, 'grey')} more" if len(parted) > 1 else ""
        yield (
            f"nav2 itself may read the grey {grey} as {_called(theirs)} where this page says "
            f"{_called(ours)}{more}: it lies on a threshold, and nav2 rounds it"
        )
    if image.colours:
        yield (
            "the image has colours: this page takes the mean of red, green and blue, and nav2 "
            "itself weighs green more. Save it in greys"
        )


def _called(cell: int) -> str:
    return {UNKNOWN: "unknown", 0: "free", 100: "occupied"}.get(cell, str(cell))


def _in_24_bits(grey: int, settings: Settings) -> int:
    """The cell of an opaque pixel as nav2 works it out, in numbers of single precision."""
    p = _single(grey / 255)
    if not settings.negate:
        p = _single(1 - p)
    free, occupied = _single(settings.free), _single(settings.occupied)
    if p <= free:
        return 0
    if p >= occupied:
        return 100
    if settings.mode is not Mode.SCALE:
        return UNKNOWN
    room = _single(settings.occupied - settings.free)
    return int(_single(_single(_single(p - free) / room) * 100) + 0.5) if room > 0 else UNKNOWN


def _single(number: float) -> float:
    """The nearest number of single precision; the largest there is for one beyond."""
    try:
        return float(struct.unpack("<f", struct.pack("<f", number))[0])
    except OverflowError:
        return float("inf") if number > 0 else float("-inf")
