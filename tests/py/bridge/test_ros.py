"""ROS maps for the page: saved as an archive, opened from files, a file's faults told."""

from __future__ import annotations

import io
import json
import zipfile
from base64 import b64decode, b64encode
from typing import Any

import pytest

from bridge.ros import convert

YAML = """image: rooms/room.pgm
resolution: 0.5
origin: [0.25, -1.0, 0.1]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""
PGM = b"P5\n3 2\n255\n" + bytes([0, 205, 254, 254, 254, 0])
"""The top row first: occupied, unknown, free; below it free, free, occupied."""


def asked(**request: Any) -> dict[str, Any]:
    answer: dict[str, Any] = json.loads(convert(json.dumps(request)))
    return answer


def opened(**files: bytes) -> dict[str, Any]:
    sent = [
        {"name": name.replace("_", "."), "bytes": b64encode(data).decode()}
        for name, data in files.items()
    ]
    return asked(act="open", files=sent)


def test_a_map_is_read_from_the_bottom_with_its_settings() -> None:
    answer = opened(room_yaml=YAML.encode(), Room_PGM=PGM)
    assert list(b64decode(answer.pop("cells"))) == [0, 0, 100, 100, 255, 0]
    assert answer == {
        "name": "room.yaml",
        "width": 3,
        "height": 2,
        "resolution": 0.5,
        "origin": [0.25, -1.0, 0.1],
        "mode": "trinary",
        "negate": False,
        "occupied_thresh": 0.65,
        "free_thresh": 0.196,
    }


def test_what_is_saved_opens_again_from_its_archive() -> None:
    saved = asked(
        act="save", name="room", cell_cm=100, free=[[50, 50], [150, 50]], occupied=[[150, 50]]
    )
    counts = {key: saved[key] for key in ("file", "free", "occupied", "unknown")}
    # A cell that is drawn as both is occupied: nobody should drive there.
    assert counts == {"file": "room.zip", "free": 1, "occupied": 1, "unknown": 2}
    again = opened(room_zip=b64decode(saved["bytes"]))
    assert again["name"] == "room.yaml"
    assert (again["width"], again["resolution"], again["origin"]) == (2, 1.0, [0.0, 0.0, 0.0])
    assert list(b64decode(again["cells"])) == [0, 100, 255, 255]


def test_an_archive_may_have_a_folder_and_other_files() -> None:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr("maps/", "")
        archive.writestr("maps/room.yaml", YAML)
        archive.writestr("maps/rooms/room.pgm", PGM)
        archive.writestr("maps/notes.txt", "mapped on Monday")
    assert opened(maps_zip=packed.getvalue())["width"] == 3


@pytest.mark.parametrize(
    ("files", "said"),
    [
        ({"room_pgm": PGM}, "there is no YAML file among room.pgm"),
        (
            {"room_yaml": YAML.encode()},
            "room.yaml names the image room.pgm, which was not chosen with it: choose both",
        ),
        (
            {"room_yaml": YAML.encode(), "hall_png": PGM},
            "choose both together; there is hall.png",
        ),
        ({"a_yaml": b"", "b_yaml": b""}, "choose one map at a time: there are a.yaml, b.yaml"),
        ({"room_yaml": b"\xff\xfe"}, "room.yaml does not hold text"),
        (
            {"room_yaml": YAML.replace("0.5", "half").encode(), "room_pgm": PGM},
            "room.yaml: line 2 of the map's YAML file: resolution should be a number",
        ),
        (
            {"room_yaml": YAML.encode(), "room_pgm": b"GIF89a"},
            "room.pgm: the map's image is neither a PGM nor a PNG file",
        ),
        ({"room_yaml": YAML.encode(), "room_pgm": PGM[:-1]}, "room.pgm: "),
        ({"room_zip": b"PK but no archive"}, "room.zip is no zip archive, or it is damaged"),
    ],
)
def test_what_is_wrong_is_told_with_the_file(files: dict[str, bytes], said: str) -> None:
    assert said in opened(**files)["error"]


def test_a_cell_beyond_the_mat_can_not_be_saved() -> None:
    answer = asked(act="save", name="room", cell_cm=5, free=[[202.5, 2.5]], occupied=[])
    assert answer == {"error": "a cell at (202.5, 2.5) is beyond the mat"}
