"""ROS maps for the page: made of what a run has drawn, and read from files that somebody chose.

The page carries JSON both ways, with bytes as base64; `mapping.ros_map` knows the format. What is
wrong with a file comes back as {"error": text}, for the reader.

`zipfile` is imported where it is needed: it is not in the snapshot, so the page brings it first.
"""

from __future__ import annotations

import io
import json
import zlib
from base64 import b64decode, b64encode
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from bugbot.errors import WrongValueError
from mapping import ros_map
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.map_yaml import read_settings

__all__ = ["convert"]

_YAML = (".yaml", ".yml")
_IMAGE = (".pgm", ".png", ".bmp", ".jpg", ".jpeg", ".gif", ".tif", ".tiff")
_MOST_BYTES = 20_000_000
"""Of one unpacked file: more than any map that a page can show."""

Files = dict[str, bytes]


def convert(request: str) -> str:
    """Do what a request asks.

    {"act": "save", "name", "cell_cm", "free": [[x, y], …], "occupied": […]}
        -> {"file", "bytes": a zip archive of the two files, "free", "occupied", "unknown": counts}
    {"act": "open", "files": [{"name", "bytes"}, …]}
        -> {"name", "width", "height", "resolution", "origin", "mode", "negate", "occupied_thresh",
            "free_thresh", "cells": a byte for each, 255 for unknown, row after row from the bottom}
    """
    asked = json.loads(request)
    try:
        return json.dumps(_ACTS[asked["act"]](asked))
    except WrongValueError as error:
        return json.dumps({"error": str(error)})


# -- save --------------------------------------------------------------------------


def _save(asked: dict[str, Any]) -> dict[str, Any]:
    import zipfile

    grid = Grid(asked["cell_cm"])
    states = [State.UNKNOWN] * (grid.across * grid.across)
    # What is drawn as both stands in somebody's way.
    for state, points in ((State.FREE, asked["free"]), (State.OCCUPIED, asked["occupied"])):
        for x, y in points:
            index = grid.index_at(x, y)
            if index is None:
                raise WrongValueError(f"a cell at ({x:g}, {y:g}) is beyond the mat")
            states[index] = state
    name = asked["name"]
    text, image = ros_map.write(ros_map.RosMap.of_states(grid, states), f"{name}.pgm")
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(f"{name}.yaml", text)
        archive.writestr(f"{name}.pgm", image)
    return {
        "file": f"{name}.zip",
        "bytes": b64encode(packed.getvalue()).decode(),
        **{state.name.lower(): states.count(state) for state in State},
    }


# -- open --------------------------------------------------------------------------


def _open(asked: dict[str, Any]) -> dict[str, Any]:
    files = dict(_unpacked({each["name"]: b64decode(each["bytes"]) for each in asked["files"]}))
    name = _yaml_among(files)
    try:
        text = files[name].decode()
    except UnicodeDecodeError:
        raise WrongValueError(f"{name} does not hold text, so it is no YAML file") from None
    with _blaming(name):
        settings = read_settings(text)
    image = _image_among(files, name, settings.image)
    with _blaming(image):
        found = ros_map.read(text, files[image])
    return {
        "name": name,
        "width": found.width,
        "height": found.height,
        "resolution": found.resolution,
        "origin": found.origin,
        "mode": settings.mode,
        "negate": settings.negate,
        "occupied_thresh": settings.occupied,
        "free_thresh": settings.free,
        "cells": b64encode(bytes(cell & 255 for cell in found.cells)).decode(),
    }


def _unpacked(files: Files) -> Iterator[tuple[str, bytes]]:
    """The files, with those of an archive in its place; folders are left out of names."""
    import zipfile

    for name, data in files.items():
        if not name.lower().endswith(".zip"):
            yield name, data
            continue
        try:
            with zipfile.ZipFile(io.BytesIO(data)) as archive:
                for entry in archive.infolist():
                    if entry.is_dir() or not entry.filename.lower().endswith(_YAML + _IMAGE):
                        continue
                    if entry.file_size > _MOST_BYTES:
                        raise WrongValueError(
                            f"{entry.filename} in {name} takes more than {_MOST_BYTES:,} bytes"
                        )
                    yield _bare(entry.filename), archive.read(entry)
        except (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError, EOFError):
            raise WrongValueError(f"{name} is no zip archive, or it is damaged") from None


def _yaml_among(files: Files) -> str:
    found = [name for name in files if name.lower().endswith(_YAML)]
    if len(found) == 1:
        return found[0]
    there = ", ".join(sorted(files)) or "nothing"
    if found:
        raise WrongValueError(f"choose one map at a time: there are {', '.join(sorted(found))}")
    raise WrongValueError(
        "a ROS map is a YAML file and an image: choose both together, or a zip archive of the "
        f"two; there is no YAML file among {there}"
    )


def _image_among(files: Files, yaml: str, wanted: str) -> str:
    """The image that a YAML file names, whatever folder it says."""
    bare = _bare(wanted)
    for name in files:
        if name.lower() == bare.lower():
            return name
    others = [name for name in files if name != yaml]
    there = f"; there is {', '.join(sorted(others))}" if others else ""
    raise WrongValueError(
        f"{yaml} names the image {bare or '(none)'}, which was not chosen with it: choose both "
        f"together{there}"
    )


def _bare(path: str) -> str:
    return path.replace("\\", "/").rsplit("/", 1)[-1]


@contextmanager
def _blaming(name: str) -> Iterator[None]:
    """What is wrong is told with the file it is in."""
    try:
        yield
    except WrongValueError as error:
        raise WrongValueError(f"{name}: {error}") from None


_ACTS = {"save": _save, "open": _open}
