"""What the settings beside a ROS map's image say, and which of them its readers take.

May import: the standard library, `bugbot.errors`, `mapping.yaml_text` when a text is read.

Values are taken as nav2 takes them, which reads YAML with yaml-cpp. In quotes or not makes no
difference to it. `y`, `on` and the like are true for negate, as in YAML 1.1, and so is any whole
number but 0. Of the files that nav2 does take, these are refused, with what to write instead:

- a name that is there twice: YAML 1.2 forbids it, nav2 takes the first
- a last line that is no `name: value`, or a quote that is never closed: no YAML, nav2 takes them
- a resolution of 0 or less: such a map has no place on the floor
- thresholds and lengths that are no finite numbers: `.inf`, `.nan`

Names and meanings: nav2_map_server/src/map_io.cpp, ros-navigation/navigation2 (2025).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from math import isfinite
from numbers import Integral, Real

from bugbot.errors import WrongValueError, got

__all__ = ["Mode", "Reader", "Settings", "read_settings", "settings_of"]


class Mode(StrEnum):
    """How a pixel stands for a cell."""

    TRINARY = "trinary"
    SCALE = "scale"
    RAW = "raw"


class Reader(StrEnum):
    """Whose rules a file is read by."""

    NAV2 = "nav2"
    """Since April 2025: a threshold itself counts, any transparency is unknown."""
    NAV2_2024 = "nav2 before 2025"
    ROS1 = "ros 1"


@dataclass(frozen=True)
class Settings:
    """What the YAML file says.

    image           the image's name, relative to the YAML file
    resolution      side of a cell [m]
    origin          (x, y) of the lower left pixel's corner [m] and the map's turn [rad]
    negate          whether light, not dark, stands for occupied
    occupied, free  thresholds, as probabilities; usually 0 to 1 and free the smaller
    """

    image: str
    mode: Mode
    resolution: float
    origin: tuple[float, float, float]
    negate: bool
    occupied: float
    free: float


_REQUIRED = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")


def read_settings(text: str, reader: Reader = Reader.NAV2) -> Settings:
    """Raises WrongValueError that names the line, or what is missing."""
    try:
        from mapping.yaml_text import top_level
    except ModuleNotFoundError as error:
        if error.name != "yaml":
            raise
        raise ModuleNotFoundError(
            "A map's YAML file is read with PyYAML, which is not installed: pip install PyYAML",
            name="yaml",
        ) from None
    entries = top_level(text)
    values = {name: entry.value for name, entry in entries.items()}
    return _Reading(values, reader, {name: each.line for name, each in entries.items()}).settings()


def settings_of(values: Mapping[str, object], reader: Reader = Reader.NAV2) -> Settings:
    """The settings in a dictionary, as if they stood in a YAML file.

    Numbers may be numbers or their text. Names that no reader knows are left out.
    Raises WrongValueError that says which setting a reader refuses, and what it wants.

    >>> told = {"image": "a.pgm", "resolution": 0.05, "origin": [0, 0, 0], "negate": 0}
    >>> settings_of({**told, "occupied_thresh": 0.65, "free_thresh": 0.196}).mode
    <Mode.TRINARY: 'trinary'>
    """
    return _Reading(values, reader).settings()


_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*", re.ASCII)
"""A number as both YAML 1.2 and yaml-cpp have it: no 1_000, no 0x10, no comma."""
_WHOLE = re.compile(r"[-+]?(?:0[xX][0-9a-fA-F]{1,8}|0[0-7]{0,10}|[1-9]\d{0,8})\s*", re.ASCII)
_TRUE = frozenset(("y", "yes", "true", "on"))
_FALSE = frozenset(("n", "no", "false", "off"))


@dataclass(frozen=True)
class _Reading:
    """Values that are being read, for one reader, with their lines if they have any."""

    values: Mapping[str, object]
    reader: Reader
    lines: Mapping[str, int] = field(default_factory=dict)

    def settings(self) -> Settings:
        missing = [name for name in _REQUIRED if name not in self.values]
        if missing:
            raise WrongValueError(self._missing(missing[0]))
        return Settings(
            image=self._image(),
            mode=self._mode(),
            resolution=self._resolution(),
            origin=self._origin(),
            negate=self._negate(),
            occupied=self._number("occupied_thresh", self.values["occupied_thresh"]),
            free=self._number("free_thresh", self.values["free_thresh"]),
        )

    def _missing(self, name: str) -> str:
        alike = [str(each) for each in self.values if str(each).strip().lower() == name]
        hint = f" (it has {alike[0]}: names are in small letters)" if alike else ""
        source = "map's YAML file has" if self.lines else "settings have"
        return f"the {source} no {name}{hint}: what is needed is {', '.join(_REQUIRED)}"

    def _refused(self, name: str, wanted: str, value: object) -> WrongValueError:
        where = f"line {self.lines[name]} of the map's YAML file: " if name in self.lines else ""
        told = "neither a text nor a list" if value is None else got(value)
        return WrongValueError(f"{where}{name} should be {wanted}; it is {told}")

    def _image(self) -> str:
        value = self.values["image"]
        if not isinstance(value, str) or not value:
            raise self._refused("image", "the name of the image's file", value)
        return value

    def _mode(self) -> Mode:
        value = self.values.get("mode", Mode.TRINARY)
        word = value if isinstance(value, str) else ""
        if self.reader is not Reader.ROS1:  # ROS 1 knows small letters alone
            word = word.lower()
        if word not in list(Mode):
            raise self._refused("mode", "trinary, scale or raw", value)
        return Mode(word)

    def _resolution(self) -> float:
        value = self._number("resolution", self.values["resolution"])
        if not value > 0:
            raise self._refused("resolution", "above 0 (m), such as 0.05", value)
        return value

    def _origin(self) -> tuple[float, float, float]:
        value = self.values["origin"]
        parts = list(value) if isinstance(value, Iterable) and not isinstance(value, str) else []
        if isinstance(value, Mapping) or len(parts) != 3:
            raise self._refused("origin", "[x, y, yaw] in brackets, with commas", value)
        x, y, yaw = (self._number("origin", part, "three numbers") for part in parts)
        return x, y, yaw

    def _number(self, name: str, value: object, wanted: str = "a number") -> float:
        number = float("nan")
        if isinstance(value, str) and _NUMBER.fullmatch(value):
            number = float(value)
        elif isinstance(value, Real) and not isinstance(value, bool):
            try:
                number = float(value)
            except OverflowError:
                number = float("inf")
        if not isfinite(number):
            raise self._refused(name, wanted, value)
        return number

    def _negate(self) -> bool:
        value = self.values["negate"]
        if isinstance(value, (bool, Integral)):
            return bool(value)
        if isinstance(value, str):
            if _WHOLE.fullmatch(value):
                return any(digit in "123456789abcdefABCDEF" for digit in value)
            # tRUE is none of the spellings that are read: true, True and TRUE are.
            usual = value in (value.lower(), value.upper(), value.capitalize())
            if usual and self.reader is not Reader.ROS1 and value.lower() in _TRUE | _FALSE:
                return value.lower() in _TRUE
        raise self._refused("negate", "0 or 1", value)
