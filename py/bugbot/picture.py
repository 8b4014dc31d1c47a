"""A picture of how a run ended, for the command line.

May import: the standard library, `bugbot.frames`, `bugbot.checks`, `bugbot.trace`,
`bugbot.errors`, and Pillow, which is imported only when a picture is asked for.
"""

from __future__ import annotations

from math import ceil
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bugbot.checks import rgb
from bugbot.errors import BugbotError
from bugbot.frames import MAT_CM, ROBOT_RADIUS_CM, direction
from bugbot.trace import Trace

if TYPE_CHECKING:
    from PIL.ImageDraw import ImageDraw
    from PIL.ImageFont import FreeTypeFont, ImageFont

__all__ = ["PictureError", "save_picture"]

_SCALE = 4
"""Pixels per cm."""
_MARGIN = 40
"""Round the mat, for the scale [pixels]."""
_GRID_CM = 50

_PAPER, _MAT, _INK, _LINES = "#f7f4ec", "#ffffff", "#3c3a36", "#e4dfd2"
_SOLID, _TRAIL, _ROBOT = "#c9c2b2", "#7fae93", "#2f7d55"

_Point = tuple[float, float]


class PictureError(BugbotError):
    """The picture can't be made or saved; says what to do."""


def save_picture(trace: Trace, path: Path) -> None:
    """Draw the end of a run: mat, obstacles, layers, trail and robot; save it as PNG."""
    try:
        from PIL import Image, ImageDraw, ImageFont
    except ImportError:
        raise PictureError("--png needs Pillow: python -m pip install pillow") from None
    side = round(MAT_CM * _SCALE) + 2 * _MARGIN
    image = Image.new("RGB", (side, side), _PAPER)
    sheet = _Sheet(ImageDraw.Draw(image), ImageFont.load_default)
    sheet.mat()
    for obstacle in trace.header["world"]["obstacles"]:
        sheet.obstacle(obstacle)
    poses = [(event["x"], event["y"], event["heading"]) for event in trace.of_kind("pose")]
    layers = {event["name"]: event for event in trace.of_kind("layer")}
    for layer in layers.values():
        sheet.layer(layer, trace.points_of(layer))
    sheet.trail([(x, y) for x, y, _ in poses])
    sheet.robot(*poses[-1])
    try:
        image.save(path, "PNG")
    except OSError as error:
        raise PictureError(f"can't write {path}: {error.strerror}") from None


class _Sheet:
    """A drawing in cm on the mat, y up."""

    def __init__(self, draw: ImageDraw, font: Any) -> None:
        self._draw = draw
        self._font = font

    def _at(self, x: float, y: float) -> _Point:
        return _MARGIN + x * _SCALE, _MARGIN + (MAT_CM - y) * _SCALE

    def _box(self, x0: float, y0: float, x1: float, y1: float) -> tuple[float, float, float, float]:
        # Pillow's corners belong to the box: one pixel less, or neighbours overlap.
        left, low = self._at(x0, y0)
        right, high = self._at(x1, y1)
        return round(left), round(high), round(right) - 1, round(low) - 1

    def _letters(self, cm: float) -> FreeTypeFont | ImageFont:
        font: FreeTypeFont | ImageFont = self._font(max(8, round(cm * _SCALE)))
        return font

    def mat(self) -> None:
        self._draw.rectangle(self._box(0, 0, MAT_CM, MAT_CM), fill=_MAT)
        small = self._letters(3.5)
        for step in range(0, int(MAT_CM) + 1, _GRID_CM):
            self._draw.line([self._at(step, 0), self._at(step, MAT_CM)], fill=_LINES)
            self._draw.line([self._at(0, step), self._at(MAT_CM, step)], fill=_LINES)
            self._draw.text(self._at(step, -2), str(step), fill=_INK, font=small, anchor="mt")
            self._draw.text(self._at(-1.5, step), str(step), fill=_INK, font=small, anchor="rm")
        self._draw.rectangle(self._box(0, 0, MAT_CM, MAT_CM), outline=_INK, width=2)

    def obstacle(self, each: dict[str, Any]) -> None:
        box = self._box(each["x"], each["y"], each["x"] + each["width"], each["y"] + each["height"])
        self._draw.rectangle(box, fill=_SOLID, outline=_INK)

    def layer(self, layer: dict[str, Any], points: list[_Point]) -> None:
        ink, half = rgb(layer["colour"]), layer["size"] / 2
        shape = layer["shape"]
        if shape == "line":
            width = ceil(layer["size"] * _SCALE)
            self._draw.line([self._at(x, y) for x, y in points], ink, width, "curve")
            return
        font = self._letters(layer["size"])
        for number, (x, y) in enumerate(points):
            if shape == "text":
                self._draw.text(self._at(x, y), layer["texts"][number], ink, font, "mm")
            elif shape == "squares":
                self._draw.rectangle(self._box(x - half, y - half, x + half, y + half), ink)
            else:
                self._draw.ellipse(self._box(x - half, y - half, x + half, y + half), ink)

    def trail(self, places: list[_Point]) -> None:
        self._draw.line([self._at(x, y) for x, y in places], _TRAIL, 3, "curve")

    def robot(self, x: float, y: float, heading: float) -> None:
        r = ROBOT_RADIUS_CM
        self._draw.ellipse(self._box(x - r, y - r, x + r, y + r), _ROBOT, _INK, 2)
        east, north = direction(heading)
        nose = self._at(x + r * east, y + r * north)
        self._draw.line([self._at(x, y), nose], "#ffffff", 5)
