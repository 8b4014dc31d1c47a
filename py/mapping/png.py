"""PNG files, every kind that the specification allows.

May import: the standard library, `bugbot.errors`, `mapping.image`.

A wrong check sum makes a part that is needed unreadable; a part that can be left out is left alone.
Samples of 16 bits become 8 by dividing by 257 and rounding down, as nav2's image library does, so
alpha is 255 only where a pixel is opaque. That library sees a colour of an RGB file of 8 bits that
is named as transparent (tRNS) only if it is black; here it is transparent whatever it is.

Where it comes from: W3C, "Portable Network Graphics (PNG) Specification", 3rd edition.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from bugbot.errors import WrongValueError, got
from mapping.image import Image, bits_table, checked_size, image_of, samples_of_16

__all__ = ["SIGNATURE", "read_png", "undo_filters"]

SIGNATURE = b"\x89PNG\r\n\x1a\n"

_AGAIN = "save it again as an 8-bit greyscale PNG, or as a PGM"
_GREY, _RGB, _PALETTE, _GREY_ALPHA, _RGBA = 0, 2, 3, 4, 6
_SAMPLES = {_GREY: 1, _RGB: 3, _PALETTE: 1, _GREY_ALPHA: 2, _RGBA: 4}
"""Samples of a pixel by the file's colour type."""
_DEPTHS = {_GREY: (1, 2, 4, 8, 16), _PALETTE: (1, 2, 4, 8)}
_DEPTHS_OF_OTHERS = (8, 16)

_WHOLE = ((0, 0, 1, 1),)
_ADAM7 = (
    *((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4)),
    *((0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)),
)
"""First column and row of each pass, and the steps to the next ones."""


@dataclass(frozen=True)
class _Pass:
    """Every so many columns across and rows down from (x, y), and how many of them there are."""

    x: int
    y: int
    across: int
    down: int
    width: int
    height: int


@dataclass(frozen=True)
class _Header:
    width: int
    height: int
    depth: int
    kind: int
    interlaced: bool

    @property
    def pixel_bits(self) -> int:
        return _SAMPLES[self.kind] * self.depth

    def row_bytes(self, width: int) -> int:
        return (width * self.pixel_bits + 7) // 8

    def passes(self) -> Iterator[_Pass]:
        """Those that have pixels."""
        for x, y, across, down in _ADAM7 if self.interlaced else _WHOLE:
            width = (self.width - x + across - 1) // across
            height = (self.height - y + down - 1) // down
            if width > 0 and height > 0:
                yield _Pass(x, y, across, down, width, height)


def read_png(data: bytes, undo: Callable[[bytearray, int, int], None]) -> Image:
    """Raises WrongValueError that says what is wrong with the file.

    undo  as `undo_filters`
    """
    parts = _chunks(data)
    header = _header(*next(parts))
    chunks = list(parts)
    before = chunks[: next((i for i, (name, _) in enumerate(chunks) if name == b"IDAT"), None)]
    colours = _palette(before) if header.kind == _PALETTE else b""
    clear = _transparency(before, header, len(colours) // 3)
    raw = _unpacked(b"".join(part for name, part in chunks if name == b"IDAT"), header)
    passes: list[tuple[_Pass, list[bytes]]] = []
    start = 0
    for each in header.passes():
        row_bytes = header.row_bytes(each.width)
        end = start + each.height * (row_bytes + 1)
        flat = _without_filters(raw[start:end], row_bytes, max(1, header.pixel_bits // 8), undo)
        passes.append((each, _planes(flat, each.width, header, colours, clear)))
        start = end
    planes = _woven(passes, header) if header.interlaced else passes[0][1]
    hidden = clear is not None and header.kind == _RGB and header.depth == 8
    return image_of(header.width, header.height, planes, [_CLEAR_RGB] if hidden else [])


_CLEAR_RGB = (
    "a colour of the PNG file is named as transparent (tRNS), which nav2 may not see in an RGB "
    "file: save it with an alpha channel"
)


def _woven(passes: list[tuple[_Pass, list[bytes]]], header: _Header) -> list[bytes]:
    """The planes of the image, of those of its passes."""
    planes = [bytearray(header.width * header.height) for _ in passes[0][1]]
    for each, parts in passes:
        for plane, part in zip(planes, parts, strict=True):
            for row in range(each.height):
                first = (each.y + row * each.down) * header.width
                pixels = part[row * each.width : (row + 1) * each.width]
                plane[first + each.x : first + header.width : each.across] = pixels
    return [bytes(plane) for plane in planes]


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Name and content of each part, up to the last one that counts."""
    place = len(SIGNATURE)
    while place + 12 <= len(data):
        (length,) = struct.unpack_from(">I", data, place)
        name = data[place + 4 : place + 8]
        part = data[place + 8 : place + 8 + length]
        critical = not name[0] & 0x20
        if len(part) < length or (
            critical
            and zlib.crc32(part, zlib.crc32(name))
            != int.from_bytes(data[place + 8 + length : place + 12 + length], "big")
        ):
            raise WrongValueError(
                f"the PNG file is damaged: a part of it does not add up; {_AGAIN}"
            )
        if critical and name not in (b"IHDR", b"PLTE", b"IDAT", b"IEND"):
            raise WrongValueError(
                f"the PNG file has a part named {got(name.decode('latin-1'))} that readers don't "
                f"know and may not leave out: {_AGAIN}"
            )
        yield name, part
        if name == b"IEND":
            return
        place += 12 + length
    raise WrongValueError(f"the PNG file ends before its last part: {_AGAIN}")


def _header(name: bytes, part: bytes) -> _Header:
    if name != b"IHDR" or len(part) != 13:
        raise WrongValueError(f"the PNG file does not begin with its header: {_AGAIN}")
    width, height, depth, kind, packing, filtering, interlace = struct.unpack(">IIBBBBB", part)
    fits = kind in _SAMPLES and depth in _DEPTHS.get(kind, _DEPTHS_OF_OTHERS)
    if not fits or packing or filtering or interlace > 1:
        raise WrongValueError(f"the PNG file's header says what no PNG file may say: {_AGAIN}")
    checked_size(width, height)
    return _Header(width, height, depth, kind, interlace == 1)


def _palette(before: list[tuple[bytes, bytes]]) -> bytes:
    found = [part for name, part in before if name == b"PLTE"]
    if len(found) != 1 or len(found[0]) % 3 or not 3 <= len(found[0]) <= 768:
        raise WrongValueError(f"the PNG file should have one palette of 1 to 256 colours: {_AGAIN}")
    return found[0]


def _transparency(before: list[tuple[bytes, bytes]], header: _Header, colours: int) -> bytes | None:
    """What tRNS says, if it stands where it may and is as long as it has to be."""
    names = [name for name, _ in before]
    if b"tRNS" not in names:
        return None
    at = names.index(b"tRNS")
    part = before[at][1]
    if header.kind == _PALETTE:
        return part if 1 <= len(part) <= colours and names.index(b"PLTE") < at else None
    return part if len(part) == {_GREY: 2, _RGB: 6}.get(header.kind) else None


def _unpacked(packed: bytes, header: _Header) -> bytearray:
    """The rows of all passes with their filters' numbers, checked by the stream's own sum."""
    wanted = sum(each.height * (header.row_bytes(each.width) + 1) for each in header.passes())
    stream = zlib.decompressobj()
    try:
        raw = bytearray(stream.decompress(packed, wanted))
        # The sum is looked at when one asks for more; rows beyond the last are left alone.
        stream.decompress(stream.unconsumed_tail, 1)
    except zlib.error as error:
        raise WrongValueError(
            f"the PNG file's pixels can't be unpacked: {error}; {_AGAIN}"
        ) from None
    if len(raw) < wanted:
        raise WrongValueError(
            f"the PNG file ends after {len(raw)} of {wanted} bytes of pixels: {_AGAIN}"
        )
    return raw


def _without_filters(
    raw: bytearray, row_bytes: int, pixel_bytes: int, undo: Callable[[bytearray, int, int], None]
) -> bytes:
    """The rows alone."""
    step = row_bytes + 1
    kinds = raw[::step]
    if max(kinds) > 4:
        raise WrongValueError(f"the PNG file has a row of an unknown kind, {max(kinds)}: {_AGAIN}")
    if any(kinds):
        undo(raw, row_bytes, pixel_bytes)
    view = memoryview(raw)
    return b"".join(view[start + 1 : start + step] for start in range(0, len(raw), step))


def undo_filters(raw: bytearray, row_bytes: int, pixel_bytes: int) -> None:
    """Undo in place the filter of each row (section 9 of the specification).

    raw          rows, each a byte that tells its filter (0 to 4) and row_bytes bytes
    pixel_bytes  from a byte to the one of the same sample to the left
    """
    above = bytearray(row_bytes)
    for start in range(0, len(raw), row_bytes + 1):
        kind = raw[start]
        row = raw[start + 1 : start + 1 + row_bytes]
        if kind == 1:
            for i in range(pixel_bytes, row_bytes):
                row[i] = (row[i] + row[i - pixel_bytes]) & 255
        elif kind == 2:
            row = bytearray((a + b) & 255 for a, b in zip(row, above, strict=True))
        elif kind == 3:
            for i in range(row_bytes):
                left = row[i - pixel_bytes] if i >= pixel_bytes else 0
                row[i] = (row[i] + (left + above[i]) // 2) & 255
        elif kind == 4:
            for i in range(row_bytes):
                left = row[i - pixel_bytes] if i >= pixel_bytes else 0
                corner = above[i - pixel_bytes] if i >= pixel_bytes else 0
                row[i] = (row[i] + _paeth(left, above[i], corner)) & 255
        raw[start + 1 : start + 1 + row_bytes] = row
        above = row


def _paeth(left: int, up: int, corner: int) -> int:
    guess = left + up - corner
    to_left, to_up, to_corner = abs(guess - left), abs(guess - up), abs(guess - corner)
    if to_left <= to_up and to_left <= to_corner:
        return left
    return up if to_up <= to_corner else corner


def _planes(
    flat: bytes, width: int, header: _Header, colours: bytes, clear: bytes | None
) -> list[bytes]:
    """Grey, or red, green and blue; and alpha, if there is some. A byte a pixel each."""
    parts = _SAMPLES[header.kind]
    if header.depth < 8:
        flat = _spread(flat, header.row_bytes(width), header.depth, width)
    if header.kind == _PALETTE:
        return _looked_up(flat, colours, clear)
    alpha = None if clear is None else _apart_from(flat, header.depth, clear)
    if header.depth == 16:
        flat = bytes(map(_NARROWED.__getitem__, samples_of_16(flat)))
    elif header.depth < 8:
        most = (1 << header.depth) - 1
        flat = flat.translate(bytes(255 * min(value, most) // most for value in range(256)))
    planes = [flat[i::parts] for i in range(parts)] if parts > 1 else [flat]
    return planes if alpha is None else [*planes, alpha]


_NARROWED = [value // 257 for value in range(65536)]


def _spread(flat: bytes, row_bytes: int, depth: int, width: int) -> bytes:
    """A byte a sample, from rows of samples of 1, 2 or 4 bits."""
    table = bits_table(depth)
    return b"".join(
        b"".join(map(table.__getitem__, flat[start : start + row_bytes]))[:width]
        for start in range(0, len(flat), row_bytes)
    )


def _looked_up(flat: bytes, colours: bytes, clear: bytes | None) -> list[bytes]:
    if max(flat) * 3 + 3 > len(colours):
        raise WrongValueError(
            f"the PNG file names a colour that its palette does not have: {_AGAIN}"
        )
    tables = [colours[i::3].ljust(256, b"\0") for i in range(3)]
    if clear is not None:
        tables.append(clear.ljust(256, b"\xff"))
    return [flat.translate(table) for table in tables]


def _apart_from(flat: bytes, depth: int, clear: bytes) -> bytes | None:
    """0 for each pixel that is of the colour named as transparent, 255 for the others."""
    key = clear if depth == 16 else clear[1::2]
    if depth < 16 and any(clear[0::2]):
        return None  # no sample is as large as that
    differs = 0
    for i, byte in enumerate(key):
        table = bytes(0 if value == byte else 255 for value in range(256))
        differs |= int.from_bytes(flat[i :: len(key)].translate(table), "big")
    return differs.to_bytes(len(flat) // len(key), "big")
