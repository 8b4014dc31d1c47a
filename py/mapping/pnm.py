"""PGM files and their relatives: PBM (black and white) and PPM (colours), plain and binary.

May import: the standard library, `bugbot.errors`, `mapping.image`.

Where it comes from: the pbm(5), pgm(5) and ppm(5) pages of Netpbm. A comment ends with its line,
and a line with LF; after the header stands one blank, so CR and LF there are a blank and a pixel.
Greys of another scale are stretched to 255 by way of 16 bits and rounded down, as nav2's image
library does. That library misreads 15 and more pixels of a binary file whose largest grey is 15 or
less (1.3.40: grey 1 becomes white); here they are read as the page of the format says.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from bugbot.errors import WrongValueError, counted
from mapping.image import Image, bits_table, checked_size, image_of, samples_of_16

__all__ = ["KINDS", "read_pnm"]

KINDS = {
    b"P1": ("PBM", 1),
    b"P2": ("PGM", 1),
    b"P3": ("PPM", 3),
    b"P4": ("PBM", 1),
    b"P5": ("PGM", 1),
    b"P6": ("PPM", 3),
}
"""What a file begins with -> how it is called, and samples of a pixel."""

_AGAIN = "save it again as a PGM of 8 bits"
_NUMBER = re.compile(rb"(?:\s|#[^\n]*\n)*(\d{1,9})(?!\d)")
_BITS = bytes(255 if bit == 0 else 0 for bit in range(256))
"""1 is black."""


def read_pnm(data: bytes) -> Image:
    """Raises WrongValueError that says what is wrong with the file."""
    kind = data[:2]
    name, parts = KINDS[kind]
    bitmap = name == "PBM"
    numbers, place = _header(data, name, 2 if bitmap else 3)
    width, height = numbers[:2]
    most = 1 if bitmap else numbers[2]
    if not 1 <= most <= 65535:
        raise WrongValueError(
            f"the {name} file's largest grey should be 1 to 65535; it is {most}: {_AGAIN}"
        )
    size = checked_size(width, height)
    wanted = size * parts
    doubts: list[str] = []
    if kind == b"P4":
        samples = _bits(data[place + 1 :], width, height)
    elif kind == b"P1":
        samples = _plain_bits(data[place:])[:size]
    elif kind in (b"P5", b"P6"):
        samples = _binary(data[place + 1 :], wanted, most, name)
        header_ends = data[place : place + 2]
        if header_ends == b"\r\n" and len(data) - place - 1 > wanted * (1 if most < 256 else 2):
            doubts.append(
                f"the {name} file's header ends in CR and LF: readers take the LF for the first "
                f"pixel, and all others move on by one. {_AGAIN.capitalize()}"
            )
    else:
        samples, cut = _plain(data, place, wanted, most, name)
        if cut:
            doubts.append(
                f"the {name} file has no line end after its last number: nav2 refuses it, until "
                "one is written there"
            )
    if len(samples) < wanted:
        raise WrongValueError(
            f"the {name} file ends after {len(samples) // parts} of "
            f"{counted(size, 'pixel')}: {_AGAIN}"
        )
    planes = [samples[i::parts] for i in range(parts)] if parts > 1 else [samples]
    return image_of(width, height, planes, doubts)


def _header(data: bytes, name: str, how_many: int) -> tuple[list[int], int]:
    """Its numbers, and the place after the last one."""
    place = 2
    numbers = []
    for _ in range(how_many):
        found = _NUMBER.match(data, place)
        if found is None:
            given = "width and height" if how_many == 2 else "width, height and 255"
            raise WrongValueError(
                f"the {name} file's first lines should give {given}, and comments end with a "
                f"line feed: {_AGAIN}"
            )
        numbers.append(int(found[1]))
        place = found.end()
    return numbers, place


def _stretched(most: int) -> list[int]:
    """The grey of 8 bits for each value."""
    return [(2 * 65535 * value + most) // (2 * most) // 257 for value in range(most + 1)]


def _too_large(name: str, value: int, most: int) -> WrongValueError:
    return WrongValueError(
        f"the {name} file has the grey {value}, but its first lines say that {most} is the "
        f"largest: {_AGAIN}"
    )


def _binary(raster: bytes, wanted: int, most: int, name: str) -> bytes:
    if most == 255:
        return raster[:wanted]
    if most < 255:
        greys = raster[:wanted]
        if greys and max(greys) > most:
            raise _too_large(name, max(greys), most)
        return greys.translate(bytes(_stretched(most)).ljust(256, b"\xff"))
    pairs = raster[: 2 * wanted]
    samples = samples_of_16(pairs[: len(pairs) // 2 * 2])
    if samples and max(samples) > most:
        raise _too_large(name, max(samples), most)
    return bytes(map(_stretched(most).__getitem__, samples))


def _bits(raster: bytes, width: int, height: int) -> bytes:
    row_bytes = (width + 7) // 8
    table = bits_table(1)
    rows = []
    for start in range(0, min(len(raster), height * row_bytes), row_bytes):
        row = raster[start : start + row_bytes]
        rows.append(b"".join(map(table.__getitem__, row))[:width])
    return b"".join(rows).translate(_BITS)


def _plain_bits(text: bytes) -> bytes:
    """Of digits that may or may not be apart."""
    digits = re.sub(rb"#[^\n]*", b"", text).translate(None, b" \t\r\n\v\f")
    found = re.match(rb"[01]*", digits)
    return (found[0] if found else b"").translate(bytes(255 - 255 * (i & 1) for i in range(256)))


def _plain(data: bytes, place: int, wanted: int, most: int, name: str) -> tuple[bytes, bool]:
    """Greys of numbers that are written out; and whether the file ends right after the last."""
    table = _stretched(most)
    known: dict[bytes, int] = {}
    greys = bytearray()
    for piece, is_last in _pieces(data, place):
        numbers = piece.split()
        missing = wanted - len(greys)
        for number in set(numbers[:missing]) - known.keys():
            if not re.fullmatch(rb"\d{1,9}", number):
                raise WrongValueError(
                    f"the {name} file has {number[:20].decode('latin-1')!r} where a grey should "
                    f"be: {_AGAIN}"
                )
            if int(number) > most:
                raise _too_large(name, int(number), most)
            known[number] = table[int(number)]
        greys += bytes(map(known.__getitem__, numbers[:missing]))
        if len(greys) == wanted:
            return bytes(greys), is_last and len(numbers) == missing and not piece[-1:].isspace()
    return bytes(greys), False


_PIECE = 1 << 20
"""So many letters at a time: the words of a large file would fill the memory."""


def _pieces(data: bytes, place: int) -> Iterator[tuple[bytes, bool]]:
    """The text without its comments, in pieces that end between two numbers."""
    text = re.sub(rb"#[^\n]*", b" ", data[place:]) if data.find(b"#", place) >= 0 else data[place:]
    start = 0
    while start < len(text):
        end = min(len(text), start + _PIECE)
        while end < len(text) and not text[end : end + 1].isspace():
            end += 1
        yield text[start:end], end == len(text)
        start = end
