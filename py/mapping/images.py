"""The two image formats of map files, PGM and PNG, as far as maps use them.

May import: the standard library, `bugbot.errors`.

An image is rows of pixels from the TOP down: grey 0 to 255 (colours are averaged) and, in some
PNG files, alpha 0 (transparent) to 255 (opaque).

Where it comes from:
  the pgm(5) page of Netpbm; W3C, "Portable Network Graphics (PNG) Specification", 3rd edition
"""

from __future__ import annotations

import re
import struct
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from bugbot.errors import WrongValueError

__all__ = ["Image", "read_image", "write_pgm", "write_png"]

MOST_PIXELS = 64_000_000
"""A larger image is refused: no map of a mat, and too much for a page."""

_PNG = b"\x89PNG\r\n\x1a\n"


@dataclass(frozen=True)
class Image:
    """grey holds width * height bytes, row after row from the top; alpha as many, or None."""

    width: int
    height: int
    grey: bytes
    alpha: bytes | None = None

    def __post_init__(self) -> None:
        size = self.width * self.height
        lengths = {len(self.grey), len(self.grey if self.alpha is None else self.alpha)}
        if min(self.width, self.height) < 1 or lengths != {size}:
            raise WrongValueError(
                f"an image of {self.width} by {self.height} pixels wants as many greys and "
                f"alphas; it got {sorted(lengths)}"
            )


def read_image(data: bytes) -> Image:
    """A PGM (P2 or P5) or PNG file. Raises WrongValueError that says what is wrong with it."""
    if data.startswith(_PNG):
        return _read_png(data)
    if data[:2] in (b"P2", b"P5"):
        return _read_pgm(data)
    raise WrongValueError("the map's image is neither a PGM nor a PNG file: save it as one of them")


def write_pgm(image: Image) -> bytes:
    """A binary PGM file; alpha is left out."""
    return b"P5\n%d %d\n255\n" % (image.width, image.height) + image.grey


def write_png(image: Image) -> bytes:
    """A PNG file: 8 bits of grey, and of alpha if the image has it."""
    samples = [image.grey] if image.alpha is None else [image.grey, image.alpha]
    row_bytes = image.width * len(samples)
    mixed = bytearray(row_bytes * image.height)
    for i, each in enumerate(samples):
        mixed[i :: len(samples)] = each
    rows = (b"\0" + mixed[start : start + row_bytes] for start in range(0, len(mixed), row_bytes))
    colour_type = 0 if image.alpha is None else 4
    header = struct.pack(">IIBBBBB", image.width, image.height, 8, colour_type, 0, 0, 0)
    return b"".join(
        [
            _PNG,
            _chunk(b"IHDR", header),
            _chunk(b"IDAT", zlib.compress(b"".join(rows), 9)),
            _chunk(b"IEND", b""),
        ]
    )


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


# -- PGM ---------------------------------------------------------------------------

_TOKEN = re.compile(rb"(?:\s|#[^\n]*\n)*(\d+)")


def _read_pgm(data: bytes) -> Image:
    place = 2
    numbers = []
    for _ in range(3):
        found = _TOKEN.match(data, place)
        if found is None:
            raise WrongValueError("the PGM file's first lines should give width, height and 255")
        numbers.append(int(found[1]))
        place = found.end()
    width, height, most = numbers
    if not 1 <= most <= 255:
        raise WrongValueError(f"the PGM file's largest grey should be 1 to 255; it is {most}")
    size = _checked_size(width, height)
    if data[:2] == b"P5":
        values: Iterable[int] = data[place + 1 : place + 1 + size]  # one blank ends the header
    else:
        values = (int(each[1]) for each in _TOKEN.finditer(data, place))
    if most != 255:
        values = (min(255, value * 255 // most) for value in values)
    try:
        grey = bytes(values)[:size]
    except ValueError:
        raise WrongValueError("the PGM file has a grey above 255") from None
    if len(grey) < size:
        raise WrongValueError(f"the PGM file ends after {len(grey)} of {size} pixels")
    return Image(width, height, grey)


# -- PNG ---------------------------------------------------------------------------

_SAMPLES = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
"""Samples of a pixel by the PNG file's colour type."""


def _read_png(data: bytes) -> Image:
    chunks = list(_chunks(data))
    if not chunks or chunks[0][0] != b"IHDR" or len(chunks[0][1]) != 13:
        raise WrongValueError("the PNG file does not begin with its header")
    width, height, depth, kind, _, _, interlaced = struct.unpack(">IIBBBBB", chunks[0][1])
    if kind not in _SAMPLES or depth not in (1, 2, 4, 8) or (depth != 8 and kind not in (0, 3)):
        raise WrongValueError(
            "the PNG file should have 8 bits or fewer for a colour: save it as 8-bit greyscale"
        )
    if interlaced:
        raise WrongValueError("the PNG file is interlaced: save it without interlacing")
    _checked_size(width, height)
    row_bytes = (width * _SAMPLES[kind] * depth + 7) // 8
    most = height * (row_bytes + 1)
    packed = b"".join(part for name, part in chunks if name == b"IDAT")
    try:
        raw = zlib.decompressobj().decompress(packed, most)
    except zlib.error as error:
        raise WrongValueError(f"the PNG file's pixels can't be unpacked: {error}") from None
    if len(raw) < most:
        raise WrongValueError(f"the PNG file ends after {len(raw)} of {most} bytes of pixels")
    rows = _unfiltered(raw, row_bytes, max(1, _SAMPLES[kind] * depth // 8))
    if depth < 8:
        rows = [_spread(row, depth, width, grey=kind == 0) for row in rows]
    flat = b"".join(rows)
    if kind == 0:
        return Image(width, height, flat)
    if kind == 4:
        return Image(width, height, flat[0::2], flat[1::2])
    if kind == 3:
        colours = dict(chunks).get(b"PLTE", b"")
        alphas = dict(chunks).get(b"tRNS")
        if max(flat) * 3 + 3 > len(colours):
            raise WrongValueError("the PNG file names a colour that its palette does not have")
        table = bytes(sum(colours[i : i + 3]) // 3 for i in range(0, len(colours), 3))
        table += bytes(256 - len(table))
        alpha = None if alphas is None else flat.translate(alphas.ljust(256, b"\xff"))
        return Image(width, height, flat.translate(table), alpha)
    step = _SAMPLES[kind]
    parts = zip(flat[0::step], flat[1::step], flat[2::step], strict=True)
    grey = bytes(sum(rgb) // 3 for rgb in parts)
    return Image(width, height, grey, flat[3::4] if step == 4 else None)


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    place = len(_PNG)
    while place + 12 <= len(data):
        (length,) = struct.unpack_from(">I", data, place)
        name = data[place + 4 : place + 8]
        part = data[place + 8 : place + 8 + length]
        if len(part) < length or zlib.crc32(name + part) != int.from_bytes(
            data[place + 8 + length : place + 12 + length], "big"
        ):
            raise WrongValueError("the PNG file is damaged: a part of it does not add up")
        yield name, part
        place += 12 + length


def _unfiltered(raw: bytes, row_bytes: int, pixel_bytes: int) -> list[bytes]:
    """Undo the filter of each row (section 9 of the specification)."""
    rows = []
    above = bytearray(row_bytes)
    for start in range(0, len(raw), row_bytes + 1):
        kind, row = raw[start], bytearray(raw[start + 1 : start + 1 + row_bytes])
        if kind > 4:
            raise WrongValueError(f"the PNG file has a row of an unknown kind, {kind}")
        if kind:
            for i in range(row_bytes):
                left = row[i - pixel_bytes] if i >= pixel_bytes else 0
                corner = above[i - pixel_bytes] if i >= pixel_bytes else 0
                guess = (left, above[i], (left + above[i]) // 2, _paeth(left, above[i], corner))
                row[i] = (row[i] + guess[kind - 1]) & 255
        rows.append(bytes(row))
        above = row
    return rows


def _paeth(left: int, up: int, corner: int) -> int:
    guess = left + up - corner
    to_left, to_up, to_corner = abs(guess - left), abs(guess - up), abs(guess - corner)
    if to_left <= to_up and to_left <= to_corner:
        return left
    return up if to_up <= to_corner else corner


def _spread(row: bytes, depth: int, width: int, *, grey: bool) -> bytes:
    """One byte a pixel, from rows of 1, 2 or 4 bits a pixel; greys are stretched to 255."""
    most = (1 << depth) - 1
    scale = 255 // most if grey else 1
    per_byte = 8 // depth
    return bytes(
        (row[i // per_byte] >> (8 - depth - depth * (i % per_byte)) & most) * scale
        for i in range(width)
    )


def _checked_size(width: int, height: int) -> int:
    size = width * height
    if not 1 <= size <= MOST_PIXELS:
        raise WrongValueError(
            f"the map's image should have 1 to {MOST_PIXELS} pixels; it is {width} by {height}"
        )
    return size
