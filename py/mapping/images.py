"""The images of map files: PGM and its relatives, and PNG.

May import: the standard library, `bugbot.errors`, `mapping.image`, `mapping.pnm`, `mapping.png`.

An image is rows of pixels from the TOP down: grey 0 to 255 and, in some PNG files, alpha 0
(transparent) to 255 (opaque). What is read: PGM, PBM and PPM, plain and binary, of 8 or 16 bits,
and every PNG file that its specification allows. Where a reader of ROS maps takes what a format
forbids, the file is refused with what to do; where it refuses what a format allows, the file is
read and the image's `doubts` say so.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable

from bugbot.errors import WrongValueError
from mapping.image import Image
from mapping.png import SIGNATURE, read_png, undo_filters
from mapping.pnm import KINDS, read_pnm

__all__ = ["Image", "read_image", "write_pgm", "write_png"]


def read_image(data: bytes, undo: Callable[[bytearray, int, int], None] = undo_filters) -> Image:
    """A PGM, PBM, PPM or PNG file. Raises WrongValueError that says what is wrong with it.

    undo  what takes away the filters of a PNG file's rows; a page has a faster one
    """
    if data.startswith(SIGNATURE):
        return read_png(data, undo)
    if data[:2] in KINDS:
        return read_pnm(data)
    raise WrongValueError("the map's image is neither a PGM nor a PNG file: save it as one of them")


def write_pgm(image: Image) -> bytes:
    """A binary PGM file; alpha is left out."""
    return b"P5\n%d %d\n255\n" % (image.width, image.height) + image.grey


def write_png(image: Image) -> bytes:
    """A PNG file of 8 bits: grey, or red, green, blue and alpha if the image has alpha.

    Grey and alpha alone would do, but nav2 before 2025 misreads such a file.
    """
    grey, alpha = image.grey, image.alpha
    samples = [grey] if alpha is None else [grey, grey, grey, alpha]
    row_bytes = image.width * len(samples)
    mixed = bytearray(row_bytes * image.height)
    for i, each in enumerate(samples):
        mixed[i :: len(samples)] = each
    rows = (b"\0" + mixed[start : start + row_bytes] for start in range(0, len(mixed), row_bytes))
    header = struct.pack(
        ">IIBBBBB", image.width, image.height, 8, 0 if alpha is None else 6, 0, 0, 0
    )
    return b"".join(
        [
            SIGNATURE,
            _chunk(b"IHDR", header),
            _chunk(b"IDAT", zlib.compress(b"".join(rows), 9)),
            _chunk(b"IEND", b""),
        ]
    )


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
