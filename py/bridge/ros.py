"""ROS maps for the page: made of what a run has drawn, and read from files that somebody chose.

The page carries JSON both ways, and bytes beside it; `mapping.ros_map` knows the format. What is
wrong with a file comes back as {"error": text}, for the reader.

The page brings `zipfile`, and PyYAML, before it asks: they are not in the snapshot.
"""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from bridge.map_files import MapFile, image_for, text_of, unpacked, yaml_among
from bugbot.errors import WrongValueError
from mapping import ros_map
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.images import read_image
from mapping.map_yaml import read_settings
from mapping.png import undo_filters
from mapping.ros_readers import cell_bytes, doubts

__all__ = ["convert"]

Undo = Callable[[bytearray, int, int], None]


def convert(
    request: str,
    files: Sequence[Any],
    send: Callable[[str, bytes | None], None],
    undo: Undo = undo_filters,
) -> None:
    """Do what a request asks, and send the answer with its bytes.

    {"act": "save", "name", "cell_cm", "free": [[x, y], …], "occupied": […]}
        -> {"file", "free", "occupied", "unknown": counts}; a zip archive of the two files
    {"act": "open", "names": [name, …]}, with the files' contents in the same order
        -> {"name", "width", "height", "resolution", "origin", "mode", "negate", "occupied_thresh",
            "free_thresh", "doubts": what to tell of it}; a byte for each cell, 255 for unknown,
            row after row from the bottom

    files  bytes, or the page's Uint8Arrays
    undo   as `mapping.png.undo_filters`
    """
    asked = json.loads(request)
    data = [each if isinstance(each, bytes) else each.to_bytes() for each in files]
    try:
        answer, content = _save(asked) if asked["act"] == "save" else _open(asked, data, undo)
    except WrongValueError as error:
        answer, content = {"error": str(error)}, None
    send(json.dumps(answer), content)


def _save(asked: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
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
    counts = {state.name.lower(): states.count(state) for state in State}
    return {"file": f"{name}.zip", **counts}, packed.getvalue()


def _open(
    asked: dict[str, Any], contents: Sequence[bytes], undo: Undo
) -> tuple[dict[str, Any], bytes]:
    files = unpacked(
        [MapFile(name, data) for name, data in zip(asked["names"], contents, strict=True)]
    )
    yaml = yaml_among(files)
    text = text_of(yaml)
    with _blaming(yaml.name):
        settings = read_settings(text)
    file, minded = image_for(files, yaml, settings.image)
    with _blaming(file.name):
        image = read_image(file.data, undo)
    answer = {
        "name": yaml.name,
        "width": image.width,
        "height": image.height,
        "resolution": settings.resolution,
        "origin": settings.origin,
        "mode": settings.mode,
        "negate": settings.negate,
        "occupied_thresh": settings.occupied,
        "free_thresh": settings.free,
        "doubts": [*minded, *doubts(image, settings)],
    }
    return answer, cell_bytes(image, settings)


@contextmanager
def _blaming(name: str) -> Iterator[None]:
    """What is wrong is told with the file it is in."""
    try:
        yield
    except WrongValueError as error:
        raise WrongValueError(f"{name}: {error}") from None
