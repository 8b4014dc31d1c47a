"""Files with what the real readers of ROS maps make of them, held against what ours make.

`ros/` has a folder a case. `ros/readers.json` has what nav2 (a3a97043), nav2 before 2025 (f1cbaa46)
and ROS 1 (noetic) read, the first cells from the bottom left, or "refuses". Where ours differs on
purpose, "ours" has the answer and "why" the reason; all else must be equal.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from bugbot.errors import WrongValueError
from mapping.images import read_image
from mapping.map_yaml import Mode, read_settings
from mapping.ros_map import Reader, RosMap, read, write
from mapping.ros_readers import doubts

FOLDER = Path(__file__).parent / "ros"
CASES: dict[str, Any] = json.loads((FOLDER / "readers.json").read_text(encoding="utf-8"))


def files_of(case: str) -> tuple[str, bytes]:
    folder = FOLDER / case
    (image,) = [path for path in folder.iterdir() if path.name != "map.yaml"]
    return (folder / "map.yaml").read_bytes().decode(), image.read_bytes()


def ours(case: str, reader: Reader) -> list[int] | str:
    try:
        return list(read(*files_of(case), reader).cells)
    except WrongValueError:
        return "refuses"


def test_every_case_has_its_folder_and_every_difference_its_reason() -> None:
    assert {path.name for path in FOLDER.iterdir() if path.is_dir()} == set(CASES)
    for name, case in CASES.items():
        assert set(case.get("ours", {})) == set(case.get("why", {})), name


@pytest.mark.parametrize("reader", list(Reader))
@pytest.mark.parametrize("name", list(CASES))
def test_ours_reads_what_the_real_one_reads(name: str, reader: Reader) -> None:
    case = CASES[name]
    wanted = case.get("ours", {}).get(reader, case["real"][reader])
    got = ours(name, reader)
    assert got == wanted if isinstance(wanted, str) else got[: len(wanted)] == wanted


NAV2_DIFFERS = [
    name
    for name, case in CASES.items()
    if Reader.NAV2 in case.get("ours", {}) and case["ours"][Reader.NAV2] != "refuses"
]


@pytest.mark.parametrize("name", NAV2_DIFFERS)
def test_where_nav2_makes_it_otherwise_there_is_a_word(name: str) -> None:
    text, image = files_of(name)
    told = " ".join(doubts(read_image(image), read_settings(text)))
    known = {"i06-maxval-15-P5", "w4-our-name-hash"}  # in the docstring; a name, not a pixel
    assert name in known or "nav2" in told


@pytest.mark.parametrize(
    ("free", "negate", "grey", "said"),
    [
        (
            0.25,
            0,
            205,
            "the grey 205, which most programs write for unknown, is read as free floor",
        ),
        (0.196, 1, 205, "is read as occupied (its p is 0.804): 1 cell. negate: 0 is usual"),
        (0.196, 0, 205, None),
        (0.25, 0, 254, None),
    ],
)
def test_unknown_that_turns_into_floor_or_wall_is_told(
    free: float, negate: int, grey: int, said: str | None
) -> None:
    text = (
        f"image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: {negate}\n"
        f"occupied_thresh: 0.65\nfree_thresh: {free}\n"
    )
    told = doubts(read_image(b"P5\n1 1\n255\n" + bytes([grey])), read_settings(text))
    assert told == [] if said is None else said in told[0]


@pytest.mark.parametrize(
    ("occupied", "free", "said"),
    [(0.2, 0.65, "above occupied_thresh (0.2)"), (65, 0.25, "occupied_thresh is 65, but")],
)
def test_thresholds_that_make_no_sense_are_told(occupied: float, free: float, said: str) -> None:
    text = (
        "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
        f"occupied_thresh: {occupied}\nfree_thresh: {free}\n"
    )
    assert said in doubts(read_image(b"P5\n1 1\n255\n\0"), read_settings(text))[0]


@pytest.mark.parametrize(
    "name", ["my map #2.pgm", "[1].pgm", "a: b.pgm", 'it"s.pgm', "it's.pgm", "küche.pgm", "- x.pgm"]
)
def test_a_name_is_quoted_so_that_it_comes_back(name: str) -> None:
    text, _ = write(RosMap(1, 1, (0,), 0.05), name)
    assert read_settings(text).image == name


@pytest.mark.parametrize(
    "origin", [(1234567.89, -9876543.21, 1.5707963267948966), (1e-7, 1e22, -0.1), (0, 0, 0)]
)
def test_an_origin_keeps_its_digits(origin: tuple[float, float, float]) -> None:
    text, image = write(RosMap(1, 1, (0,), 0.07, origin), "m.pgm")
    back = read(text, image)
    assert (back.origin, back.resolution) == (origin, 0.07)


def test_a_scale_map_is_a_png_of_colours_and_alpha_as_nav2_writes_it() -> None:
    text, image = write(RosMap(2, 1, (-1, 50), 0.05), "m.png", Mode.SCALE)
    assert image[24:26] == bytes([8, 6])
    for reader in Reader:
        assert read(text, image, reader).cells[0] == -1
