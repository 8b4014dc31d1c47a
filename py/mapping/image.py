"""An image of a map, and what its readers share.

May import: the standard library, `bugbot.errors`.

A map may have 16 million cells, so nothing here takes a step of Python for each pixel: values are
looked up by `bytes.translate` or by a `map` over a table.
"""

from __future__ import annotations

import sys
from array import array
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from operator import add

from bugbot.errors import WrongValueError

__all__ = ["MOST_PIXELS", "Image", "bits_table", "checked_size", "image_of", "samples_of_16"]

MOST_PIXELS = 64_000_000
"""A larger image is refused: no map of a mat, and too much for a page."""


@dataclass(frozen=True)
class Image:
    """A picture as a map's reader sees it; each field of bytes has width * height of them.

    grey     the pixels row after row from the top; the mean of the colours, rounded down, where
             there are some
    alpha    0 (transparent) to 255 (opaque); None where the file says nothing of it
    colours  red, green and blue, where any pixel is not grey
    doubts   what another reader of the same file may make otherwise, in words
    """

    width: int
    height: int
    grey: bytes
    alpha: bytes | None = None
    colours: tuple[bytes, bytes, bytes] | None = None
    doubts: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        size = self.width * self.height
        planes = [self.grey, *([] if self.alpha is None else [self.alpha]), *(self.colours or ())]
        lengths = {len(plane) for plane in planes}
        if min(self.width, self.height) < 1 or lengths != {size}:
            raise WrongValueError(
                f"an image of {self.width} by {self.height} pixels wants as many greys and "
                f"alphas; it got {sorted(lengths)}"
            )


def image_of(width: int, height: int, planes: Sequence[bytes], doubts: Sequence[str] = ()) -> Image:
    """An image of its planes: grey; grey, alpha; red, green, blue; or these and alpha."""
    alpha = planes[-1] if len(planes) in (2, 4) else None
    if len(planes) < 3 or planes[0] == planes[1] == planes[2]:
        return Image(width, height, planes[0], alpha, None, tuple(doubts))
    red, green, blue = planes[:3]
    sums = map(add, map(add, red, green), blue)
    grey = bytes(map(_THIRDS.__getitem__, sums))
    return Image(width, height, grey, alpha, (red, green, blue), tuple(doubts))


_THIRDS = [total // 3 for total in range(3 * 255 + 1)]


def checked_size(width: int, height: int) -> int:
    """How many pixels that is; WrongValueError for none or far too many."""
    size = width * height
    if not 1 <= size <= MOST_PIXELS:
        raise WrongValueError(
            f"the map's image should have 1 to {MOST_PIXELS} pixels; it is {width} by {height}"
        )
    return size


@lru_cache
def bits_table(depth: int) -> list[bytes]:
    """For each byte the samples of 1, 2 or 4 bits that are packed in it, the leftmost first."""
    most = (1 << depth) - 1
    shifts = range(8 - depth, -1, -depth)
    return [bytes(byte >> shift & most for shift in shifts) for byte in range(256)]


def samples_of_16(data: bytes) -> array[int]:
    """The samples in pairs of bytes, the more significant first."""
    samples = array("H", data)
    if sys.byteorder == "little":
        samples.byteswap()
    return samples
