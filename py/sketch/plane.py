"""A window on the mat, or a chart's field, on a drawing: its own units, y up.

May import: the standard library, `bugbot.frames`. The only place where y is turned over.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from bugbot.frames import ROBOT_RADIUS_CM, direction

if TYPE_CHECKING:
    from sketch.drawing import Drawing, Point

__all__ = ["Plane"]

Cell = tuple[int, int]


class Plane:
    """Made by `Drawing.plane`, which says what its numbers mean."""

    def __init__(
        self,
        drawing: Drawing,
        corner: Point,
        scale: Point,
        size: Point,
        origin: Point,
    ) -> None:
        self._drawing = drawing
        self._corner, self._scale, self._size, self._origin = corner, scale, size, origin

    def on_sheet(self, point: Point) -> Point:
        """Where a point is on the drawing."""
        right = (point[0] - self._origin[0]) * self._scale[0]
        up = (point[1] - self._origin[1]) * self._scale[1]
        return self._corner[0] + right, self._corner[1] + self._size[1] * self._scale[1] - up

    def ground(self, kind: str = "mat") -> None:
        """Fill the whole window."""
        self.rectangle(self._origin, *self._size, kind)

    def grid(self, step: float, kind: str = "grid") -> None:
        """Lines between the cells, from the origin's multiples on."""
        (left, bottom), (width, height) = self._origin, self._size
        across, up = round(width / step), round(height / step)
        for i in range(across + 1):
            x = left + i * step
            self.line((x, bottom), (x, bottom + height), kind)
        for i in range(up + 1):
            y = bottom + i * step
            self.line((left, y), (left + width, y), kind)

    def rectangle(self, corner: Point, width: float, height: float, kind: str) -> None:
        """A rectangle by its lower left corner, as obstacles are given."""
        x, y = self.on_sheet((corner[0], corner[1] + height))
        self._drawing.rectangle((x, y), width * self._scale[0], height * self._scale[1], kind)

    def cells(self, cells: Iterable[Cell], kind: str, cell_cm: float) -> None:
        """Squares of a grid by (column, row)."""
        for column, row in cells:
            self.rectangle((column * cell_cm, row * cell_cm), cell_cm, cell_cm, kind)

    def line(self, start: Point, end: Point, kind: str) -> None:
        """A straight line."""
        self._drawing.line(self.on_sheet(start), self.on_sheet(end), kind)

    def curve(self, points: Iterable[Point], kind: str = "curve", *, closed: bool = False) -> None:
        """A line through all the points; closed, an area."""
        self._drawing.polyline(map(self.on_sheet, points), kind, closed=closed)

    def arrow(self, start: Point, end: Point, kind: str = "arrow") -> None:
        """A line with a head at its end."""
        self._drawing.arrow(self.on_sheet(start), self.on_sheet(end), kind)

    def dot(self, point: Point, radius: float, kind: str) -> None:
        """A circle whose radius is in units of the drawing."""
        self._drawing.circle(self.on_sheet(point), radius, kind)

    def cross(self, point: Point, radius: float, kind: str = "missed") -> None:
        """An x, its arms in units of the drawing."""
        x, y = self.on_sheet(point)
        self._drawing.line((x - radius, y - radius), (x + radius, y + radius), kind)
        self._drawing.line((x - radius, y + radius), (x + radius, y - radius), kind)

    def robot(self, point: Point, heading_deg: float) -> None:
        """The robot as the overhead view shows it: a disc with a light nose."""
        dx, dy = direction(heading_deg)
        radius = ROBOT_RADIUS_CM * self._scale[0]
        nose = (point[0] + 0.55 * ROBOT_RADIUS_CM * dx, point[1] + 0.55 * ROBOT_RADIUS_CM * dy)
        self.dot(point, radius, "robot")
        self.dot(nose, 0.26 * radius, "nose")

    def text(self, point: Point, words: str, kind: str = "ink", *, down: float = 0.0) -> None:
        """Words at a point, moved down by so many units of the drawing (4 centres them)."""
        x, y = self.on_sheet(point)
        self._drawing.text(x, y + down, words, kind)
