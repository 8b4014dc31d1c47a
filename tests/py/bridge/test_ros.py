"""ROS maps for the page: saved as an archive, opened from files, a file's faults told."""

from __future__ import annotations

import io
import json
import struct
import zipfile
import zlib
from collections.abc import Mapping
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


def png(header: tuple[int, ...], rows: bytes) -> bytes:
    def chunk(kind: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        )

    parts = (
        (b"IHDR", struct.pack(">IIBBBBB", *header)),
        (b"IDAT", zlib.compress(rows)),
        (b"IEND", b""),
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts)


def asked(*files: bytes, **request: Any) -> tuple[dict[str, Any], bytes | None]:
    sent: list[tuple[str, bytes | None]] = []
    convert(json.dumps(request), files, lambda text, data: sent.append((text, data)))
    ((text, data),) = sent
    return json.loads(text), data


def opened(files: Mapping[str, bytes]) -> tuple[dict[str, Any], bytes | None]:
    return asked(*files.values(), act="open", names=list(files))


def refused(files: Mapping[str, bytes]) -> str:
    answer, data = opened(files)
    assert data is None
    return str(answer["error"])


def archive(files: Mapping[str, bytes | str]) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as made:
        for name, data in files.items():
            made.writestr(name, data)
    return packed.getvalue()


def test_a_map_is_read_from_the_bottom_with_its_settings() -> None:
    answer, cells = opened({"room.yaml": YAML.encode(), "room.pgm": PGM})
    assert cells == bytes([0, 0, 100, 100, 255, 0])
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
        "doubts": [],
    }


def test_what_is_saved_opens_again_from_its_archive() -> None:
    saved, packed = asked(
        act="save", name="room", cell_cm=100, free=[[50, 50], [150, 50]], occupied=[[150, 50]]
    )
    counts = {key: saved[key] for key in ("file", "free", "occupied", "unknown")}
    # A cell that is drawn as both is occupied: nobody should drive there.
    assert counts == {"file": "room.zip", "free": 1, "occupied": 1, "unknown": 2}
    again, cells = opened({"room.zip": packed or b""})
    assert again["name"] == "room.yaml"
    assert (again["width"], again["resolution"], again["origin"]) == (2, 1.0, [0.0, 0.0, 0.0])
    assert cells == bytes([0, 100, 255, 255])


@pytest.mark.parametrize(
    "files",
    [
        {
            "maps/": "",
            "maps/room.yaml": YAML,
            "maps/rooms/room.pgm": PGM,
            "maps/notes.txt": "Monday",
        },
        # A Mac's own archive has a twin of each file, and what its Finder knows of the folder.
        {
            "map/room.yaml": YAML,
            "__MACOSX/map/._room.yaml": b"\0\5\x16\7",
            "map/rooms/room.pgm": PGM,
            "__MACOSX/map/rooms/._room.pgm": b"\0\5\x16\7",
            "map/.DS_Store": b"Bud1",
        },
        # Of two images of one name, the one where the YAML file says.
        {"room.yaml": YAML, "rooms/room.pgm": PGM, "old/room.pgm": b"P5\n1 1\n255\n\0"},
    ],
)
def test_an_archive_may_have_folders_and_other_files(files: dict[str, bytes | str]) -> None:
    answer, _ = opened({"maps.zip": archive(files)})
    assert (answer.get("error"), answer.get("width"), answer.get("doubts")) == (None, 3, [])


def test_files_that_a_mac_adds_to_a_folder_are_left_out() -> None:
    files = {"room.yaml": YAML.encode(), "room.pgm": PGM, "._room.yaml": b"\0", ".DS_Store": b"\0"}
    assert opened(files)[0]["width"] == 3


def test_a_name_with_an_accent_is_the_same_however_it_is_written() -> None:
    yaml = YAML.replace("rooms/room", "k\u00fcche").encode()
    assert opened({"room.yaml": yaml, "ku\u0308che.pgm": PGM})[0]["width"] == 3
    # An archive that does not say that its names are UTF-8, as a Mac's does not.
    packed = archive({"k\u00fcche.yaml": yaml, "k\u00fcche.pgm": PGM})
    plain = packed.replace(b"\x00\x08\x00\x00", b"\x00\x00\x00\x00")
    answer, _ = opened({"maps.zip": plain})
    assert answer["name"] == "k\u00fcche.yaml"


def test_text_may_be_utf_8_or_16_with_a_mark() -> None:
    for encoding in ("utf-8-sig", "utf-16"):
        assert opened({"room.yaml": YAML.encode(encoding), "room.pgm": PGM})[0]["width"] == 3


@pytest.mark.parametrize("name", ["map#2.pgm", "my map.pgm", "[1].pgm"])
def test_a_name_may_have_signs_that_yaml_knows(name: str) -> None:
    text = YAML.replace("rooms/room.pgm", name if name == "map#2.pgm" else f'"{name}"')
    assert opened({"room.yaml": text.encode(), name: PGM})[0]["width"] == 3


@pytest.mark.parametrize(
    ("files", "said"),
    [
        ({"room.yaml": YAML.encode(), "Room.PGM": PGM}, "the file is Room.PGM: ROS tells capitals"),
        (
            {"room.yaml": YAML.replace("rooms/", "rooms\\").encode(), "room.pgm": PGM},
            "ROS wants / in place of",
        ),
        (
            {"maps.zip": archive({"a.yaml": YAML, "b/room.pgm": PGM})},
            "in the archive it is b/room.pgm",
        ),
        (
            {"room.yaml": YAML.replace("0.196", "0.25").encode(), "room.pgm": PGM},
            "the grey 205, which most programs write for unknown, is read as free floor "
            "(its p is 0.196): 1 cell",
        ),
    ],
)
def test_what_ros_would_mind_is_told(files: dict[str, bytes], said: str) -> None:
    answer, _ = opened(files)
    assert said in answer["doubts"][0]


def test_the_pages_own_loop_is_used_for_the_rows_of_a_png_file() -> None:
    filtered = png((2, 2, 8, 0, 0, 0, 0), b"\2\1\2\2\1\2")
    files = {"room.yaml": YAML.replace("pgm", "png").encode(), "room.png": filtered}
    asked_for: list[tuple[int, int]] = []

    def undo(rows: bytearray, row_bytes: int, pixel_bytes: int) -> None:
        asked_for.append((row_bytes, pixel_bytes))
        rows[:] = b"\2\0\xfe\2\xcd\0"

    sent: list[bytes | None] = []
    request = json.dumps({"act": "open", "names": list(files)})
    convert(request, list(files.values()), lambda _, data: sent.append(data), undo)
    assert (asked_for, sent) == ([(2, 1)], [bytes([255, 100, 100, 0])])


@pytest.mark.parametrize(
    ("files", "said"),
    [
        ({"room.pgm": PGM}, "there is no YAML file among room.pgm"),
        (
            {"room.yaml": YAML.encode()},
            "room.yaml names the image room.pgm, which was not chosen with it: choose both",
        ),
        (
            {"room.yaml": YAML.encode(), "hall.png": PGM},
            "choose both together; there is hall.png",
        ),
        ({"a.yaml": b"", "b.yaml": b""}, "choose one map at a time: there are a.yaml, b.yaml"),
        ({"room.yaml": b"\xff\xfe"}, "room.yaml does not hold text"),
        (
            {"room.yaml": YAML.replace("0.5", "half").encode(), "room.pgm": PGM},
            "room.yaml: line 2 of the map's YAML file: resolution should be a number",
        ),
        (
            {"room.yaml": YAML.encode(), "room.pgm": b"GIF89a"},
            "room.pgm: the map's image is neither a PGM nor a PNG file",
        ),
        ({"room.yaml": YAML.encode(), "room.pgm": PGM[:-1]}, "room.pgm: "),
        ({"room.zip": b"PK but no archive"}, "room.zip is no zip archive, or it is damaged"),
        (
            {"maps.zip": archive({"a/m.yaml": YAML, "a/m.pgm": PGM, "b/m.yaml": YAML})},
            "choose one map at a time: there are a/m.yaml, b/m.yaml",
        ),
        (
            {"maps.zip": archive({"m.yaml": YAML, "a/room.pgm": PGM, "b/room.pgm": PGM})},
            "could be one of a/room.pgm, b/room.pgm",
        ),
        (
            {"room.pgm": PGM, "maps.zip": archive({"m.yaml": YAML, "room.pgm": PGM})},
            "there are two files called room.pgm",
        ),
        (
            {"room.yaml": "# \xe9\n".encode("latin-1")},
            "room.yaml does not hold text in UTF-8: save",
        ),
    ],
)
def test_what_is_wrong_is_told_with_the_file(files: dict[str, bytes], said: str) -> None:
    assert said in refused(files)


def test_a_cell_beyond_the_mat_can_not_be_saved() -> None:
    answer = asked(act="save", name="room", cell_cm=5, free=[[202.5, 2.5]], occupied=[])
    assert answer == ({"error": "a cell at (202.5, 2.5) is beyond the mat"}, None)
