"""Images as other programs write them, held against Pillow's reading, and each refusal in words."""

import io
import random
import struct
import zlib

import pytest
from PIL import Image as Pillow

from bugbot.errors import WrongValueError
from mapping.images import Image, read_image, write_pgm, write_png

SIGNATURE = b"\x89PNG\r\n\x1a\n"
NOISE = random.Random(1).randbytes(19 * 23 * 4)


def chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(header: tuple[int, ...], rows: bytes, *more: bytes) -> bytes:
    """A file of the parts of IHDR, unpacked rows with their filters' numbers, and more chunks."""
    return b"".join(
        [
            SIGNATURE,
            chunk(b"IHDR", struct.pack(">IIBBBBB", *header)),
            *more,
            chunk(b"IDAT", zlib.compress(rows)),
            chunk(b"IEND", b""),
        ]
    )


def averaged(picture: Pillow.Image) -> bytes:
    """Grey as a map's reader has it: the mean of the colours, rounded down."""
    rgb = picture.convert("RGB").tobytes()
    return bytes(sum(rgb[i : i + 3]) // 3 for i in range(0, len(rgb), 3))


@pytest.mark.parametrize("mode", ["L", "LA", "RGB", "RGBA"])
@pytest.mark.parametrize("filtering", range(5))
def test_each_filter_of_a_row_is_undone(mode: str, filtering: int) -> None:
    # The same bytes with another filter's number are another picture; Pillow says which.
    samples = len(mode)
    kind = {"L": 0, "LA": 4, "RGB": 2, "RGBA": 6}[mode]
    width, height = 19, 23
    row = width * samples
    rows = b"".join(bytes([filtering]) + NOISE[y * row : (y + 1) * row] for y in range(height))
    data = png((width, height, 8, kind, 0, 0, 0), rows)
    picture = Pillow.open(io.BytesIO(data))
    read = read_image(data)
    assert (read.width, read.height) == (width, height)
    if mode == "LA":
        assert read.grey == picture.getchannel("L").tobytes()
    else:
        assert read.grey == averaged(picture)
    alpha = picture.getchannel("A").tobytes() if mode.endswith("A") else None
    assert read.alpha == alpha


@pytest.mark.parametrize("bits", [1, 2, 4, 8])
def test_a_palette_gives_colours_and_alphas(bits: int) -> None:
    colours = 1 << bits
    width, height = 7, 5
    picture = Pillow.new("P", (width, height))
    picture.putpalette([(37 * i) % 256 for i in range(3 * colours)])
    picture.putdata([i % colours for i in range(width * height)])
    file = io.BytesIO()
    picture.save(file, "PNG", bits=bits, transparency=bytes([10]))
    read = read_image(file.getvalue())
    again = Pillow.open(io.BytesIO(file.getvalue())).convert("RGBA")
    assert read.grey == averaged(again)
    # Only the first colour was given an alpha; the others are opaque.
    assert read.alpha == again.getchannel("A").tobytes()
    assert set(read.alpha or b"") == {10, 255}


@pytest.mark.parametrize("bits", [1, 2, 4])
def test_greys_of_few_bits_are_stretched(bits: int) -> None:
    most = (1 << bits) - 1
    rows = b"".join(bytes([0]) + NOISE[7 * y : 7 * y + (13 * bits + 7) // 8] for y in range(3))
    data = png((13, 3, bits, 0, 0, 0, 0), rows)
    levels = [round(value * 255 / most) for value in range(most + 1)]
    read = read_image(data)
    assert set(read.grey) <= set(levels)
    assert read.grey == Pillow.open(io.BytesIO(data)).convert("L").tobytes()


@pytest.mark.parametrize("alpha", [None, bytes(range(100, 106))])
def test_what_is_written_is_read_by_both(alpha: bytes | None) -> None:
    image = Image(3, 2, bytes(range(0, 60, 10)), alpha)
    data = write_png(image)
    assert read_image(data) == image
    theirs = Pillow.open(io.BytesIO(data))
    assert theirs.mode == ("L" if alpha is None else "LA")
    assert theirs.getchannel("L").tobytes() == image.grey
    assert Pillow.open(io.BytesIO(write_pgm(image))).tobytes() == image.grey
    assert read_image(write_pgm(image)) == Image(3, 2, image.grey)


GOOD = (2, 1, 8, 0, 0, 0, 0)
ROW = b"\0\1\2"


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"GIF89a", "the map's image is neither a PGM nor a PNG file: save it as one of them"),
        (SIGNATURE, "the PNG file does not begin with its header"),
        (SIGNATURE + chunk(b"IEND", b""), "the PNG file does not begin with its header"),
        (SIGNATURE + chunk(b"IHDR", b"short"), "the PNG file does not begin with its header"),
        (
            SIGNATURE + chunk(b"IDAT", bytes(13)),
            "the PNG file does not begin with its header",
        ),
        (
            png((2, 1, 16, 0, 0, 0, 0), ROW),
            "the PNG file should have 8 bits or fewer for a colour: save it as 8-bit greyscale",
        ),
        (
            png((2, 1, 4, 2, 0, 0, 0), ROW),
            "the PNG file should have 8 bits or fewer for a colour: save it as 8-bit greyscale",
        ),
        (
            png((2, 1, 8, 5, 0, 0, 0), ROW),
            "the PNG file should have 8 bits or fewer for a colour: save it as 8-bit greyscale",
        ),
        (
            png((2, 1, 3, 0, 0, 0, 0), ROW),
            "the PNG file should have 8 bits or fewer for a colour: save it as 8-bit greyscale",
        ),
        (
            png((2, 1, 8, 0, 0, 0, 1), ROW),
            "the PNG file is interlaced: save it without interlacing",
        ),
        (png(GOOD, b"\5\1\2"), "the PNG file has a row of an unknown kind, 5"),
        (png(GOOD, b"\0\1"), "the PNG file ends after 2 of 3 bytes of pixels"),
        (
            png((2, 1, 8, 3, 0, 0, 0), b"\0\0\1", chunk(b"PLTE", b"abc")),
            "the PNG file names a colour that its palette does not have",
        ),
        (
            png((2, 1, 8, 3, 0, 0, 0), b"\0\0\1"),
            "the PNG file names a colour that its palette does not have",
        ),
        (
            png(GOOD, ROW)[:-1] + b"?",
            "the PNG file is damaged: a part of it does not add up",
        ),
        (
            png((0, 1, 8, 0, 0, 0, 0), ROW),
            "the map's image should have 1 to 64000000 pixels; it is 0 by 1",
        ),
        (b"P5 2", "the PGM file's first lines should give width, height and 255"),
        (b"P5 2 1 0\n12", "the PGM file's largest grey should be 1 to 255; it is 0"),
        (b"P5 2 1 256\n12", "the PGM file's largest grey should be 1 to 255; it is 256"),
        (b"P2 2 1 255\n12 256", "the PGM file has a grey above 255"),
        (b"P2 2 1 255\n12", "the PGM file ends after 1 of 2 pixels"),
        (b"P5 2 1 255\n1", "the PGM file ends after 1 of 2 pixels"),
        (b"P5 0 1 255\n", "the map's image should have 1 to 64000000 pixels; it is 0 by 1"),
    ],
)
def test_a_broken_image_is_refused_in_these_words(data: bytes, words: str) -> None:
    with pytest.raises(WrongValueError) as refusal:
        read_image(data)
    assert str(refusal.value) == words


def test_pixels_that_cannot_be_unpacked_are_told_with_the_reason() -> None:
    data = SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", *GOOD)) + chunk(b"IDAT", b"no")
    with pytest.raises(WrongValueError, match=r"^the PNG file's pixels can't be unpacked: .*Error"):
        read_image(data)


def test_several_parts_of_pixels_are_one() -> None:
    packed = zlib.compress(b"\0\7\11")
    data = b"".join(
        [
            SIGNATURE,
            chunk(b"IHDR", struct.pack(">IIBBBBB", *GOOD)),
            *(chunk(b"IDAT", packed[i : i + 1]) for i in range(len(packed))),
            chunk(b"IEND", b""),
        ]
    )
    assert read_image(data).grey == b"\7\11"


def test_a_pgm_of_fewer_greys_is_stretched_and_comments_are_left_out() -> None:
    assert read_image(b"P2\n# made by hand\n3 1\n15\n0 # dark\n7 15\n").grey == bytes([0, 119, 255])
    assert read_image(b"P5\n2 1\n200\n\x64\xc8").grey == bytes([127, 255])


@pytest.mark.parametrize(
    ("width", "height", "grey", "alpha"),
    [(0, 1, b"", None), (1, 0, b"", None), (2, 1, b"a", None), (1, 1, b"a", b"ab")],
)
def test_an_image_wants_as_many_pixels_as_it_has(
    width: int, height: int, grey: bytes, alpha: bytes | None
) -> None:
    with pytest.raises(WrongValueError, match="wants as many greys and alphas; it got"):
        Image(width, height, grey, alpha)
