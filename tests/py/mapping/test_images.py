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
    assert theirs.mode == ("L" if alpha is None else "RGBA")
    assert theirs.getchannel(0).tobytes() == image.grey
    assert Pillow.open(io.BytesIO(write_pgm(image))).tobytes() == image.grey
    assert read_image(write_pgm(image)) == Image(3, 2, image.grey)


PNG_AGAIN = "save it again as an 8-bit greyscale PNG, or as a PGM"
AGAIN = "save it again as a PGM of 8 bits"
HEADER = f"the PNG file's header says what no PNG file may say: {PNG_AGAIN}"
PALETTE = f"the PNG file should have one palette of 1 to 256 colours: {PNG_AGAIN}"
FIRST_LINES = (
    "the PGM file's first lines should give width, height and 255, and comments end with a line "
    f"feed: {AGAIN}"
)
TOO_LARGE = (
    f"the PGM file has the grey {{}}, but its first lines say that {{}} is the largest: {AGAIN}"
)
GOOD = (2, 1, 8, 0, 0, 0, 0)
ROW = b"\0\1\2"


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"GIF89a", "the map's image is neither a PGM nor a PNG file: save it as one of them"),
        (SIGNATURE, f"the PNG file ends before its last part: {PNG_AGAIN}"),
        (
            SIGNATURE + chunk(b"IEND", b""),
            f"the PNG file does not begin with its header: {PNG_AGAIN}",
        ),
        (
            SIGNATURE + chunk(b"IHDR", b"short"),
            f"the PNG file does not begin with its header: {PNG_AGAIN}",
        ),
        (
            SIGNATURE + chunk(b"IDAT", bytes(13)),
            f"the PNG file does not begin with its header: {PNG_AGAIN}",
        ),
        (
            png((2, 1, 3, 2, 0, 0, 0), ROW),
            HEADER,
        ),
        (
            png((2, 1, 4, 2, 0, 0, 0), ROW),
            HEADER,
        ),
        (
            png((2, 1, 8, 5, 0, 0, 0), ROW),
            HEADER,
        ),
        (
            png((2, 1, 3, 0, 0, 0, 0), ROW),
            HEADER,
        ),
        (
            png((2, 1, 8, 0, 0, 0, 2), ROW),
            HEADER,
        ),
        (png(GOOD, b"\5\1\2"), f"the PNG file has a row of an unknown kind, 5: {PNG_AGAIN}"),
        (png(GOOD, b"\0\1"), f"the PNG file ends after 2 of 3 bytes of pixels: {PNG_AGAIN}"),
        (
            png((2, 1, 8, 3, 0, 0, 0), b"\0\0\1", chunk(b"PLTE", b"abc")),
            f"the PNG file names a colour that its palette does not have: {PNG_AGAIN}",
        ),
        (png((2, 1, 8, 3, 0, 0, 0), b"\0\0\1"), PALETTE),
        (png((2, 1, 8, 3, 0, 0, 0), b"\0\0\1", chunk(b"PLTE", b"four")), PALETTE),
        (png((2, 1, 8, 3, 0, 0, 0), b"\0\0\1", *2 * [chunk(b"PLTE", b"abc")]), PALETTE),
        (png((2, 1, 8, 0, 1, 0, 0), ROW), HEADER),
        (png((2, 1, 8, 0, 0, 1, 0), ROW), HEADER),
        (
            png(GOOD, ROW, chunk(b"ABCD", b"x")),
            "the PNG file has a part named 'ABCD' that readers don't know and may not leave out: "
            + PNG_AGAIN,
        ),
        (png(GOOD, ROW)[:-12], f"the PNG file ends before its last part: {PNG_AGAIN}"),
        (
            png(GOOD, ROW)[:-1] + b"?",
            f"the PNG file is damaged: a part of it does not add up; {PNG_AGAIN}",
        ),
        (
            png((0, 1, 8, 0, 0, 0, 0), ROW),
            "the map's image should have 1 to 64000000 pixels; it is 0 by 1",
        ),
        (b"P5 2", FIRST_LINES),
        (b"P5 # no line feed\r2 1 255\n12", FIRST_LINES),
        (b"P5 9999999999 1 255\n12", FIRST_LINES),
        (b"P5 2 1 0\n12", f"the PGM file's largest grey should be 1 to 65535; it is 0: {AGAIN}"),
        (
            b"P5 2 1 65536\n12",
            f"the PGM file's largest grey should be 1 to 65535; it is 65536: {AGAIN}",
        ),
        (b"P2 2 1 255\n12 256\n", TOO_LARGE.format("256", "255")),
        (b"P5 2 1 9\n\x09\x0a", TOO_LARGE.format("10", "9")),
        (b"P5 1 1 300\n\x01\x2d", TOO_LARGE.format("301", "300")),
        (b"P2 2 1 255\n12 -1\n", f"the PGM file has '-1' where a grey should be: {AGAIN}"),
        (b"P2 2 1 255\n12 1.5\n", f"the PGM file has '1.5' where a grey should be: {AGAIN}"),
        (b"P2 2 1 255\n12\n", f"the PGM file ends after 1 of 2 pixels: {AGAIN}"),
        (b"P5 2 1 255\n1", f"the PGM file ends after 1 of 2 pixels: {AGAIN}"),
        (b"P4 9 1\n1", f"the PBM file ends after 8 of 9 pixels: {AGAIN}"),
        (b"P1 2 1\n1 x", f"the PBM file ends after 1 of 2 pixels: {AGAIN}"),
        (b"P6 2 1 255\n12345", f"the PPM file ends after 1 of 2 pixels: {AGAIN}"),
        (b"P5 0 1 255\n", "the map's image should have 1 to 64000000 pixels; it is 0 by 1"),
    ],
)
def test_a_broken_image_is_refused_in_these_words(data: bytes, words: str) -> None:
    with pytest.raises(WrongValueError) as refusal:
        read_image(data)
    assert str(refusal.value) == words


def test_pixels_that_cannot_be_unpacked_are_told_with_the_reason() -> None:
    good = png(GOOD, ROW)
    packed = zlib.compress(ROW)
    for bad in (b"no", packed[:-1] + b"?"):  # the last bytes are the sum of them all
        data = good.replace(chunk(b"IDAT", packed), chunk(b"IDAT", bad))
        with pytest.raises(
            WrongValueError, match=r"^the PNG file's pixels can't be unpacked: .*rror"
        ):
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


def test_an_interlaced_file_is_the_same_picture() -> None:
    # Pillow reads such files and writes none, so the passes are taken apart here.
    width, height = 11, 9
    grey = NOISE[: width * height]
    starts = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2))
    rows = b"".join(
        b"\0" + grey[y * width + x : (y + 1) * width : across]
        for x, first, across, down in (*starts, (0, 1, 1, 2))
        for y in range(first, height, down)
    )
    data = png((width, height, 8, 0, 0, 0, 1), rows)
    assert Pillow.open(io.BytesIO(data)).tobytes() == grey
    assert read_image(data).grey == grey
    assert read_image(png((1, 1, 8, 0, 0, 0, 1), b"\0\7")).grey == b"\7"  # six empty passes


def test_samples_of_16_bits_become_8_and_only_the_fullest_alpha_is_opaque() -> None:
    samples = struct.pack(">4H", 25699, 65535, 25700, 65534)
    read = read_image(png((2, 1, 16, 4, 0, 0, 0), b"\0" + samples))
    assert (read.grey, read.alpha) == (bytes([99, 100]), bytes([255, 254]))
    assert read_image(b"P5 2 1 65535\n" + samples[:2] + samples[4:6]).grey == bytes([99, 100])
    assert read_image(b"P5 2 1 300\n\0\1\1\x2c").grey == bytes([0, 255])


@pytest.mark.parametrize(
    ("header", "row", "named", "alpha"),
    [
        ((2, 1, 8, 0, 0, 0, 0), b"\0\7\11", b"\0\11", [255, 0]),
        ((2, 1, 4, 0, 0, 0, 0), b"\0\x0f", b"\0\x0f", [255, 0]),
        ((2, 1, 16, 0, 0, 0, 0), b"\0\1\2\1\3", b"\1\3", [255, 0]),
        ((2, 1, 8, 2, 0, 0, 0), b"\0\1\2\3\1\2\4", b"\0\1\0\2\0\4", [255, 0]),
        ((2, 1, 8, 0, 0, 0, 0), b"\0\7\11", b"\1\11", None),  # no grey of 8 bits is as large
        ((2, 1, 8, 0, 0, 0, 0), b"\0\7\11", b"\11", None),  # too short: left alone
        ((2, 1, 8, 4, 0, 0, 0), b"\0\7\x80\11\x81", b"\0\11", [128, 129]),
    ],
)
def test_a_colour_named_as_transparent_is(
    header: tuple[int, ...], row: bytes, named: bytes, alpha: list[int] | None
) -> None:
    read = read_image(png(header, row, chunk(b"tRNS", named)))
    assert (None if read.alpha is None else list(read.alpha)) == alpha
    assert any("tRNS" in doubt for doubt in read.doubts) == (header[3] == 2)


def test_what_stands_after_the_end_or_can_be_left_out_is_no_matter() -> None:
    wrong = chunk(b"tEXt", b"by hand")[:-1] + b"?"
    data = png(GOOD, b"\0\7\11", wrong, chunk(b"abCd", b"?"))
    assert read_image(data + b"rubbish").grey == b"\7\11"
    assert read_image(png(GOOD, b"\0\7\11\0\1\2")).grey == b"\7\11"  # a row too many


def test_black_and_white_and_colours_of_the_pgm_family() -> None:
    assert read_image(b"P1\n# by hand\n3 2\n010\n1 0 1").grey == bytes([255, 0, 255, 0, 255, 0])
    assert read_image(b"P4\n9 1\n\x55\x80").grey == bytes([255, 0] * 4 + [0])
    colours = read_image(b"P6\n2 1\n255\n\0\xff\1\7\7\7")
    assert (colours.grey, colours.colours) == (bytes([85, 7]), (b"\0\7", b"\xff\7", b"\1\7"))
    assert read_image(b"P3 1 1 255\n7 7 7\n") == Image(1, 1, b"\7")


def test_what_another_reader_may_make_otherwise_is_told() -> None:
    assert "no line end after its last number" in read_image(b"P2 2 1 255\n1 2").doubts[0]
    assert read_image(b"P2 2 1 255\n1 2\n").doubts == ()
    assert "CR and LF" in read_image(b"P5\r\n2 1\r\n255\r\n12").doubts[0]
    assert read_image(b"P5\r\n2 1\r\n255\n12").doubts == ()


def test_a_large_plain_file_is_read_piece_by_piece() -> None:
    width = 300_000  # more letters than a piece has
    greys = bytes(range(100, 250)) * (width // 150)
    text = b" ".join(str(grey).encode() for grey in greys)
    assert read_image(b"P2 %d 1 255\n%s\n" % (width, text)).grey == greys
