"""ROS map files: each rule case by case, and maps read back by another reader."""

import io
import random

import pytest
from PIL import Image as Pillow

from bugbot.errors import WrongValueError
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.images import Image, read_image, write_pgm, write_png
from mapping.map_yaml import Mode
from mapping.ros_map import Reader, RosMap, cells_of, read, write

YAML = """image: map.pgm
mode: {mode}
resolution: 0.05
origin: [0, 0, 0]
negate: {negate}
occupied_thresh: 0.65
free_thresh: {free}
"""


def one_pixel(grey: int, alpha: int | None = None) -> bytes:
    """A map's image of one pixel."""
    return write_png(Image(1, 1, bytes([grey]), None if alpha is None else bytes([alpha])))


def cell(reader: Reader, mode: str, grey: int, alpha=None, negate="0", free=0.196) -> int:
    text = YAML.format(mode=mode, negate=negate, free=free)
    return read(text, one_pixel(grey, alpha), reader).cells[0]


@pytest.mark.parametrize(
    ("reader", "mode", "grey", "alpha", "negate", "wanted"),
    [
        # p = (255 - grey) / 255; 205 is p = 0.19608: unknown at 0.196
        (Reader.NAV2, "trinary", 254, None, "0", 0),
        (Reader.NAV2, "trinary", 205, None, "0", -1),
        (Reader.NAV2, "trinary", 206, None, "0", 0),
        (Reader.NAV2, "trinary", 0, None, "0", 100),
        (Reader.NAV2, "trinary", 90, None, "0", -1),  # p = 0.647
        (Reader.NAV2, "trinary", 89, None, "0", 100),  # p = 0.651
        (Reader.NAV2, "trinary", 0, None, "1", 0),
        (Reader.NAV2, "trinary", 255, None, "true", 100),
        (Reader.NAV2, "trinary", 0, 254, "0", -1),
        (Reader.NAV2, "scale", 0, 254, "0", -1),
        (Reader.NAV2, "scale", 147, 255, "0", 50),  # (0.42353 - 0.196) / 0.454 = 0.5012
        (Reader.NAV2, "raw", 100, None, "0", 100),
        (Reader.NAV2, "raw", 101, None, "0", -1),
        (Reader.NAV2, "raw", 37, None, "1", 37),
        (Reader.NAV2_2024, "trinary", 205, None, "0", -1),
        (Reader.NAV2_2024, "trinary", 0, 255, "0", 100),  # a quarter of 255 more light: 0.75
        (Reader.NAV2_2024, "trinary", 34, 255, "0", -1),  # so 34 is 89.25: p = 0.65 exactly
        (Reader.NAV2_2024, "scale", 0, 254, "0", -1),
        (Reader.NAV2_2024, "scale", 147, None, "0", 50),
        (Reader.NAV2_2024, "raw", 101, None, "0", -1),
        (Reader.ROS1, "trinary", 205, None, "0", -1),
        (Reader.ROS1, "trinary", 0, None, "0", 100),
        (Reader.ROS1, "scale", 147, 0, "0", -1),
        (Reader.ROS1, "scale", 147, 1, "0", 50),  # int(1 + 98 * 0.5012)
        (Reader.ROS1, "raw", 255, None, "0", -1),
        (Reader.ROS1, "raw", 100, None, "0", 100),
        (Reader.ROS1, "raw", 100, None, "1", -101),  # 155 as an int8
    ],
)
def test_a_pixel_is_read_by_each_readers_rule(reader, mode, grey, alpha, negate, wanted):
    assert cell(reader, mode, grey, alpha, negate) == wanted


def test_a_threshold_itself_counts_since_2025_and_not_before():
    # p of grey 204 is exactly 0.2; nav2 of 2024 has 1 - 0.8, a little less
    assert cell(Reader.NAV2, "trinary", 204, free=0.2) == 0
    assert cell(Reader.ROS1, "trinary", 204, free=0.2) == -1
    assert cell(Reader.NAV2, "trinary", 51, negate="1", free=0.2) == 0
    assert cell(Reader.NAV2_2024, "trinary", 51, negate="1", free=0.2) == -1


def test_the_205_trap():
    for reader in Reader:
        assert cell(reader, "trinary", 205) == -1
        assert cell(reader, "trinary", 205, free=0.25) == 0


def independent(text: str, image: bytes) -> list[list[int]]:
    """Rows from the bottom, by nav2's rules for trinary, with Pillow and nothing of ours."""
    values = dict(line.split(": ", 1) for line in text.splitlines())
    assert float(values["negate"]) == 0
    picture = Pillow.open(io.BytesIO(image)).convert("L")
    rows = []
    for y in range(picture.height - 1, -1, -1):
        row = []
        for x in range(picture.width):
            p = (255 - picture.getpixel((x, y))) / 255
            occupied, free = float(values["occupied_thresh"]), float(values["free_thresh"])
            row.append(100 if p >= occupied else 0 if p <= free else -1)
        rows.append(row)
    return rows


@pytest.mark.parametrize("png", [False, True])
def test_a_map_of_the_mat_is_read_back_cell_for_cell(png):
    grid = Grid(20)
    states = random.Random(3).choices(list(State), k=100)
    states[0], states[9], states[90] = State.OCCUPIED, State.FREE, State.UNKNOWN
    text, image = write(RosMap.of_states(grid, states), "mat.pgm", png=png)
    assert [each for row in independent(text, image) for each in row] == [int(s) for s in states]
    for reader in Reader:
        back = read(text, image, reader)
        assert back.cells == tuple(int(each) for each in states)
        assert (back.width, back.height, back.resolution, back.origin) == (10, 10, 0.2, (0, 0, 0))


def test_the_images_first_row_is_the_top_of_the_map():
    a_map = RosMap(2, 2, (100, 0, -1, -1), 0.05)  # bottom row: occupied, free
    _, image = write(a_map, "m.pgm")
    assert image == b"P5\n2 2\n255\n" + bytes([205, 205, 0, 254])


def test_scale_keeps_unknown_apart_and_raw_keeps_every_number():
    a_map = RosMap(4, 1, (-1, 0, 37, 100), 0.05)
    text, image = write(a_map, "m.png", Mode.SCALE)
    assert Pillow.open(io.BytesIO(image)).getpixel((0, 0))[3] == 0
    assert read(text, image).cells == (-1, 0, round(100 * (94 / 255 - 0.196) / 0.454), 100)
    for png in (False, True):
        assert read(*write(a_map, "m", Mode.RAW, png=png)).cells == a_map.cells
    with pytest.raises(WrongValueError, match="PNG"):
        write(a_map, "m.pgm", Mode.SCALE, png=False)


def test_cells_between_are_unknown_in_trinary():
    a_map = RosMap(5, 1, (19, 20, 21, 64, 65), 0.05)
    text, image = write(a_map, "m.pgm")
    assert read(text, image).cells == (0, 0, -1, -1, 100)


@pytest.mark.parametrize("kind", ["L", "LA", "RGB", "RGBA", "P", "1"])
def test_png_files_of_other_programs_are_read(kind):
    picture = Pillow.new("L", (7, 5))
    picture.putdata([(37 * i) % 256 for i in range(35)])
    picture = picture.convert(kind)
    packed = io.BytesIO()
    picture.save(packed, "PNG", optimize=True)
    assert list(read_image(packed.getvalue()).grey) == list(picture.convert("L").tobytes())


def test_pgm_files_of_other_programs_are_read():
    wanted = Image(3, 2, bytes([0, 85, 255, 170, 255, 0]))
    assert read_image(write_pgm(wanted)) == wanted
    assert read_image(b"P2 # by hand\n3 2\n# greys\n3\n0 1 3 2 3 0\n") == wanted
    assert read_image(b"P5\n3 2\n# CREATOR: map_saver\n255\n" + wanted.grey) == wanted


def test_a_map_wants_as_many_cells_as_it_has():
    with pytest.raises(WrongValueError, match="3"):
        RosMap(2, 2, (0, 0, 0), 0.05)
    with pytest.raises(WrongValueError, match="resolution"):
        RosMap(1, 1, (0,), 0)
    with pytest.raises(WrongValueError, match="origin"):
        RosMap(1, 1, (0,), 0.05, (float("inf"), 0, 0))


SAID = {"image": "a.pgm", "resolution": 0.05, "origin": [0, 0, 0], "negate": 0}


def test_greys_and_settings_are_read_as_the_files_of_them_would_be():
    rows = [[0, 205, 254], [254, 254, 205]]
    said = {**SAID, "occupied_thresh": 0.65, "free_thresh": 0.196}
    assert cells_of(rows, said) == [[0, 0, -1], [100, -1, 0]]
    assert cells_of(rows, {**said, "free_thresh": 0.25}) == [[0, 0, 0], [100, 0, 0]]
    assert cells_of(rows, {**said, "mode": "raw"}) == [[-1, -1, -1], [0, -1, -1]]
    for wrong in ([[256]], [[0.5]], [[0, 1], [2]], []):
        with pytest.raises(WrongValueError):
            cells_of(wrong, said)
