"""The worlds a robot can be put on: one JSON file each, and the loader.

May import: the standard library, `bugbot.errors` and `bugbot.frames`.

A world's file holds exactly what `World` holds:

    name         the file's name without `.json`
    title        a few words for a menu
    description  a sentence: what it is good for
    obstacles    a list of {x, y, width, height, name}: axis-aligned rectangles by their
                 lower left corner [cm], with the word for each ("post", "shelf")
    start        {x, y, heading} of the robot [cm, degrees clockwise from up the mat]
    camera       may be left out: false if no camera watches the mat, so that position() and
                 heading() are refused and odometry() is all that a program has
    odometry     may be left out: how this robot's motion and its belief differ from what it is told
                 {drift_deg_s, turn_scale, slip}, each of which may be left out (`Errors`)

Texts are one line of at most 300 characters, and obstacles at most 200. The site's world editor
writes such files and reads them by the same rules (site/src/page/mats/check-world.ts).
"""

from __future__ import annotations

import json
import unicodedata
from dataclasses import asdict, dataclass
from math import hypot
from pathlib import Path
from typing import Any, NoReturn

from bugbot.errors import WorldError, got, nearest
from bugbot.frames import MAT_CM, ROBOT_RADIUS_CM, wrap_heading

__all__ = ["Errors", "Obstacle", "Start", "World", "load", "names"]

_FOLDER = Path(__file__).parent

_MOST_OBSTACLES = 200
_MOST_CHARACTERS = 300


@dataclass(frozen=True, slots=True)
class Obstacle:
    """A solid rectangle, given by its lower left corner [cm]."""

    x: float
    y: float
    width: float
    height: float
    name: str

    def gap(self, x: float, y: float) -> float:
        """Distance [cm] from a point to the rectangle; 0 inside it.

        >>> Obstacle(10, 10, 5, 5, "box").gap(18, 19)
        5.0
        """
        beside = max(self.x - x, 0.0, x - (self.x + self.width))
        above = max(self.y - y, 0.0, y - (self.y + self.height))
        return hypot(beside, above)


@dataclass(frozen=True, slots=True)
class Start:
    """Where the robot stands when a run begins [cm, degrees]."""

    x: float
    y: float
    heading: float


@dataclass(frozen=True, slots=True)
class Errors:
    """How the robot of a world differs from an ideal one.

    drift_deg_s  its gyro's drift, clockwise positive [degrees/s], -1 to 1; None: as the seed has it
    turn_scale   a turn that it is told to make comes out so many times as large, 0.5 to 1.5
    slip         the share of a way by which its feet fall short, 0 to 0.5

    Turns and ways are wrong *in truth*. The gyro feels the true turn, and adds its drift. The feet
    don't notice that they slip, so odometry() counts the way that they were told to walk.
    """

    drift_deg_s: float | None = None
    turn_scale: float = 1.0
    slip: float = 0.0

    def to_dict(self) -> dict[str, float]:
        """What is not as an ideal robot has it."""
        said = {} if self.drift_deg_s is None else {"drift_deg_s": self.drift_deg_s}
        if self.turn_scale != 1.0:
            said["turn_scale"] = self.turn_scale
        if self.slip != 0.0:
            said["slip"] = self.slip
        return said


@dataclass(frozen=True, slots=True)
class World:
    """A mat with its obstacles, the robot's start, and usually a camera above."""

    name: str
    title: str
    description: str
    obstacles: tuple[Obstacle, ...]
    start: Start
    camera: bool = True
    odometry: Errors = Errors()

    def to_dict(self) -> dict[str, Any]:
        """The world as its JSON file holds it."""
        data = {**asdict(self), "obstacles": [asdict(each) for each in self.obstacles]}
        # Left out as in nearly every world, and in files written before they could be said.
        if self.camera:
            del data["camera"]
        data["odometry"] = self.odometry.to_dict()
        if not data["odometry"]:
            del data["odometry"]
        return data

    @classmethod
    def from_dict(cls, data: object, source: str = "world") -> World:
        """Check the data of a JSON file; WorldError names `source`, the field and the remedy."""
        check = _Checker(source)
        fields = check.fields(
            data,
            "",
            ("name", "title", "description", "obstacles", "start"),
            ("camera", "odometry"),
        )
        words = [check.text(fields[key], key) for key in ("name", "title", "description")]
        if not isinstance(fields["obstacles"], list):
            check.refuse("obstacles", "wants a list of rectangles", fields["obstacles"])
        count = len(fields["obstacles"])
        if count > _MOST_OBSTACLES:
            check.refuse("obstacles", f"wants at most {_MOST_OBSTACLES} rectangles", count)
        obstacles = tuple(
            check.obstacle(each, f"obstacles[{index}]")
            for index, each in enumerate(fields["obstacles"])
        )
        start = check.start(fields["start"], obstacles)
        camera = fields.get("camera", True)
        if not isinstance(camera, bool):
            check.refuse("camera", "wants true or false", camera)
        errors = check.errors(fields.get("odometry", {}))
        return cls(words[0], words[1], words[2], obstacles, start, camera, errors)


def names() -> list[str]:
    """The names of the worlds that come with bugbot, in alphabetical order."""
    return sorted(path.stem for path in _FOLDER.glob("*.json"))


def load(name_or_path: str | Path) -> World:
    """The world of that name, or of a JSON file given by its path.

    Raises WorldError: unknown name (with the nearest known one), unreadable file,
    or a field that is missing or wrong.
    """
    known = names()
    if isinstance(name_or_path, str) and name_or_path in known:
        path = _FOLDER / f"{name_or_path}.json"
    else:
        path = Path(name_or_path)
        if path.suffix != ".json":
            raise WorldError(_unknown(str(name_or_path), known))
    try:
        # Not "utf-8-sig", whose codec a page would have to fetch.
        text = path.read_text(encoding="utf-8").removeprefix("\ufeff")
    except FileNotFoundError:
        raise WorldError(f"there is no world file {path}") from None
    except (OSError, UnicodeDecodeError) as error:
        raise WorldError(f"the world file {path} can't be read: {error}") from None
    try:
        data = json.loads(text)
    except ValueError as error:
        raise WorldError(f"{path} is not JSON: {error}") from None
    except RecursionError:
        raise WorldError(f"{path} is not a world: its lists lie too deep in one another") from None
    return World.from_dict(data, str(path))


def _unknown(name: str, known: list[str]) -> str:
    near = nearest(name, known)
    meant = f" (did you mean {near!r}?)" if near else ""
    return (
        f"there is no world {name!r}{meant}; known worlds: {', '.join(known)}; "
        "or give the path of a world's .json file"
    )


class _Checker:
    """Reads the fields of one world and refuses what is wrong, naming file and field."""

    def __init__(self, source: str) -> None:
        self.source = source

    def refuse(self, field: str, wants: str, value: object) -> NoReturn:
        raise WorldError(f"{self.source}: {field or 'the world'} {wants}; it got {got(value)}")

    def fields(
        self, data: object, at: str, wanted: tuple[str, ...], allowed: tuple[str, ...] = ()
    ) -> dict[str, Any]:
        if not isinstance(data, dict):
            self.refuse(at, f"wants an object with {', '.join(wanted or allowed)}", data)
        missing = [key for key in wanted if key not in data]
        strange = [str(key) for key in data if key not in (*wanted, *allowed)]
        place = f"{at}." if at else ""
        if missing:
            raise WorldError(f"{self.source}: {place}{missing[0]} is missing; add it")
        if strange:
            raise WorldError(
                f"{self.source}: {place}{strange[0]} is not a field here; "
                f"the fields are {', '.join((*wanted, *allowed))}"
            )
        return data

    def text(self, value: object, at: str) -> str:
        if not isinstance(value, str) or not value.strip():
            self.refuse(at, "wants a text that is not empty", value)
        # Control characters, and halves of letters, which no file could be written with.
        plain = all(unicodedata.category(sign) not in ("Cc", "Cs") for sign in value)
        if not plain or len(value) > _MOST_CHARACTERS:
            self.refuse(at, f"wants one line of at most {_MOST_CHARACTERS} characters", value)
        return value

    def number(self, value: object, at: str, low: float, high: float) -> float:
        wants = f"wants a number from {low:g} to {high:g}"
        if isinstance(value, bool) or not isinstance(value, int | float):
            self.refuse(at, wants, value)
        if not low <= value <= high:  # false for NaN too
            self.refuse(at, wants, value)
        return float(value)

    def obstacle(self, data: object, at: str) -> Obstacle:
        fields = self.fields(data, at, ("x", "y", "width", "height", "name"))
        x = self.number(fields["x"], f"{at}.x", 0, MAT_CM)
        y = self.number(fields["y"], f"{at}.y", 0, MAT_CM)
        width = self.number(fields["width"], f"{at}.width", 0.1, MAT_CM - x)
        height = self.number(fields["height"], f"{at}.height", 0.1, MAT_CM - y)
        return Obstacle(x, y, width, height, self.text(fields["name"], f"{at}.name"))

    def start(self, data: object, obstacles: tuple[Obstacle, ...]) -> Start:
        fields = self.fields(data, "start", ("x", "y", "heading"))
        far = MAT_CM - ROBOT_RADIUS_CM
        x = self.number(fields["x"], "start.x", ROBOT_RADIUS_CM, far)
        y = self.number(fields["y"], "start.y", ROBOT_RADIUS_CM, far)
        heading = self.number(fields["heading"], "start.heading", -360, 360)
        for index, each in enumerate(obstacles):
            short = ROBOT_RADIUS_CM - each.gap(x, y)
            if short > 0:
                raise WorldError(
                    f"{self.source}: start ({x:g}, {y:g}) is too near obstacles[{index}], the "
                    f"{each.name}: move it {short:.1f} cm away (the robot's radius is "
                    f"{ROBOT_RADIUS_CM:g} cm)"
                )
        return Start(x, y, wrap_heading(heading))

    def errors(self, data: object) -> Errors:
        fields = self.fields(data, "odometry", (), ("drift_deg_s", "turn_scale", "slip"))
        drift = None
        if "drift_deg_s" in fields:
            drift = self.number(fields["drift_deg_s"], "odometry.drift_deg_s", -1, 1)
        turn_scale = self.number(fields.get("turn_scale", 1), "odometry.turn_scale", 0.5, 1.5)
        slip = self.number(fields.get("slip", 0), "odometry.slip", 0, 0.5)
        return Errors(drift, turn_scale, slip)
