"""The YAML file of a ROS map, as far as such files use YAML: flat `name: value` lines and lists.

May import: the standard library, `bugbot.errors`.

Names and meanings: nav2_map_server/src/map_io.cpp, ros-navigation/navigation2 (2025).
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum
from math import isfinite

from bugbot.errors import WrongValueError, got

__all__ = ["Mode", "Settings", "read_settings"]


class Mode(StrEnum):
    """How a pixel stands for a cell."""

    TRINARY = "trinary"
    SCALE = "scale"
    RAW = "raw"


@dataclass(frozen=True)
class Settings:
    """What the YAML file says.

    image           the image's name, relative to the YAML file
    resolution      side of a cell [m]
    origin          (x, y) of the lower left pixel's corner [m] and the map's turn [rad]
    negate          whether light, not dark, stands for occupied
    occupied, free  thresholds, as probabilities
    """

    image: str
    mode: Mode
    resolution: float
    origin: tuple[float, float, float]
    negate: bool
    occupied: float
    free: float


_REQUIRED = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")
_LINE = re.compile(r"""(\w+)\s*:\s*(?:"([^"]*)"|'([^']*)'|([^#]*?))\s*(?:\#.*)?$""")


def read_settings(text: str) -> Settings:
    """Raises WrongValueError that names the line, or what is missing."""
    found: dict[str, tuple[int, str]] = {}
    key = ""
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        if not bare or bare.startswith(("#", "---", "%", "...")):
            continue
        if bare.startswith("- ") and key:  # a list of one item a line
            found[key] = (found[key][0], f"{found[key][1]},{bare[2:]}")
            continue
        match = _LINE.match(bare)
        if match is None:
            raise WrongValueError(f"line {number} of the map's YAML file is no `name: value`")
        key = match[1]
        found[key] = (number, next((each for each in match.groups()[1:] if each is not None), ""))
    missing = [name for name in _REQUIRED if name not in found]
    if missing:
        raise WrongValueError(f"the map's YAML file has no {missing[0]}: it needs {_listed()}")
    mode = found.get("mode", (0, "trinary"))[1].lower()
    if mode not in list(Mode):
        raise WrongValueError(f"mode should be trinary, scale or raw; it is {got(mode)}")
    settings = Settings(
        image=found["image"][1],
        mode=Mode(mode),
        resolution=_number(found, "resolution"),
        origin=_origin(*found["origin"]),
        negate=_truth(*found["negate"]),
        occupied=_number(found, "occupied_thresh"),
        free=_number(found, "free_thresh"),
    )
    if not settings.resolution > 0:
        raise WrongValueError(f"resolution should be above 0 (m); it is {settings.resolution:g}")
    if not 0 <= settings.free <= settings.occupied <= 1:
        raise WrongValueError(
            "free_thresh should be at or under occupied_thresh, both from 0 to 1; "
            f"they are {settings.free:g} and {settings.occupied:g}"
        )
    return settings


def _listed() -> str:
    return ", ".join(_REQUIRED)


def _number(found: dict[str, tuple[int, str]], name: str) -> float:
    line, text = found[name]
    return _finite(text, line, name)


def _finite(text: str, line: int, name: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not isfinite(value):
        raise WrongValueError(
            f"line {line} of the map's YAML file: {name} should be a number; it is {got(text)}"
        )
    return value


def _origin(line: int, text: str) -> tuple[float, float, float]:
    parts = [part for part in text.strip("[] ,").split(",") if part.strip()]
    if len(parts) != 3:
        raise WrongValueError(
            f"line {line} of the map's YAML file: origin should be [x, y, yaw]; it is {got(text)}"
        )
    x, y, yaw = (_finite(part.strip(), line, "origin") for part in parts)
    return x, y, yaw


def _truth(line: int, text: str) -> bool:
    word = text.lower()
    if word in ("0", "false", "no", "off"):
        return False
    if word in ("1", "true", "yes", "on"):
        return True
    raise WrongValueError(
        f"line {line} of the map's YAML file: negate should be 0 or 1; it is {got(text)}"
    )
