"""A sheet to draw on: shapes and words as accessible SVG.

May import: the standard library, `bugbot.frames`, `sketch.plane`.

Units are those of the picture: x to the right, y down the page, as SVG has them. For anything that
lies on the mat or in a chart use `plane`, which has its own units and y up.
"""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

from bugbot.frames import direction
from sketch.plane import Plane

__all__ = ["CLASSES", "Drawing", "Point"]

Point = tuple[float, float]

CLASSES = frozenset(
    {
        # grounds of the mat, in the mat's own colours
        *("mat", "grid", "wall", "truth", "free", "occupied", "frontier", "chosen", "doubled"),
        # what lies on it
        *("robot", "nose", "beam", "rest", "step", "missed", "outline", "arrow"),
        # lines of a chart, and areas between them
        *("axis", "guide", "curve", "curve-2", "band", "band-2"),
        # words: on the page (ink, soft, strong), on the mat or a free cell (on-mat), on black
        *("ink", "soft", "strong", "on-mat", "on-black", "code", "small", "middle", "end"),
    }
)
"""What a shape or a word can be; `site/src/page/sketch.css` says how each looks."""


class Drawing:
    """One picture.

    width, height   in units; 340 wide fits a phone unit by pixel
    title           what it is, in a few words
    description     what one sees in it: all that a reader without the picture should know

    >>> drawing = Drawing(20, 10, "A dot", "One dot in the middle.")
    >>> drawing.circle((10, 5), 2, "robot")
    >>> "<circle" in drawing.svg()
    True
    """

    def __init__(self, width: float, height: float, title: str, description: str) -> None:
        self.width, self.height = width, height
        self._title, self._description = title, description
        self._parts: list[str] = []

    def plane(
        self,
        left: float,
        top: float,
        *,
        scale: float,
        width_cm: float,
        height_cm: float,
        origin: Point = (0.0, 0.0),
        scale_y: float | None = None,
    ) -> Plane:
        """A window with its own units and y up.

        left, top             where its upper left corner is on the sheet
        scale, scale_y        units of the sheet to one of its own along x and y (alike if left out)
        width_cm, height_cm   how much of its own units it shows
        origin                its own (x, y) in the lower left corner
        """
        return Plane(self, (left, top), (scale, scale_y or scale), (width_cm, height_cm), origin)

    def rectangle(self, corner: Point, width: float, height: float, kind: str) -> None:
        """A rectangle by its upper left corner."""
        x, y = map(number, corner)
        size = f'width="{number(width)}" height="{number(height)}"'
        self._add(f'<rect x="{x}" y="{y}" {size}', kind)

    def circle(self, centre: Point, radius: float, kind: str) -> None:
        """A circle, or a dot if it is small."""
        x, y = map(number, centre)
        self._add(f'<circle cx="{x}" cy="{y}" r="{number(radius)}"', kind)

    def line(self, start: Point, end: Point, kind: str) -> None:
        """A straight line."""
        self.polyline([start, end], kind)

    def polyline(self, points: Iterable[Point], kind: str, *, closed: bool = False) -> None:
        """A line through all the points."""
        way = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        self._add(f'<{"polygon" if closed else "polyline"} points="{way}"', kind)

    def arrow(self, start: Point, end: Point, kind: str = "arrow") -> None:
        """A line with a head at its end, drawn as one path."""
        (x, y), (tip_x, tip_y) = start, end
        length = ((tip_x - x) ** 2 + (tip_y - y) ** 2) ** 0.5
        along = ((tip_x - x) / length, (tip_y - y) / length)
        sides = []
        for side in (-1, 1):
            back_x = tip_x - 6 * along[0] - side * 3.5 * along[1]
            back_y = tip_y - 6 * along[1] + side * 3.5 * along[0]
            sides.append(f"{number(back_x)} {number(back_y)}")
        tip = f"{number(tip_x)} {number(tip_y)}"
        way = f"M{number(x)} {number(y)}L{tip}M{sides[0]}L{tip}L{sides[1]}"
        self._add(f'<path d="{way}"', kind)

    def arc(self, centre: Point, radius: float, from_deg: float, to_deg: float, kind: str) -> None:
        """A part of a circle between two headings [degrees clockwise from up the page]."""
        ends = []
        for heading in (from_deg, to_deg):
            dx, dy = direction(heading)
            ends.append(f"{number(centre[0] + radius * dx)} {number(centre[1] - radius * dy)}")
        large, clockwise = int(abs(to_deg - from_deg) > 180), int(to_deg > from_deg)
        size = number(radius)
        self._add(f'<path d="M{ends[0]}A{size} {size} 0 {large} {clockwise} {ends[1]}"', kind)

    def text(self, x: float, y: float, words: str, kind: str = "ink") -> None:
        """Words that begin at x (with "middle": around it, with "end": up to it), on the line y."""
        self._add(f'<text x="{number(x)}" y="{number(y)}"', kind, escape(words, quote=False))

    def svg(self) -> str:
        """The whole picture as one <svg>."""
        box = f"0 0 {number(self.width)} {number(self.height)}"
        return (
            f'<svg class="sketch" viewBox="{box}" role="img" aria-labelledby="title desc">'
            f'<title id="title">{escape(self._title, quote=False)}</title>'
            f'<desc id="desc">{escape(self._description, quote=False)}</desc>'
            f"{''.join(self._parts)}</svg>"
        )

    def _add(self, start: str, kind: str, inner: str | None = None) -> None:
        unknown = set(kind.split()) - CLASSES
        if unknown:
            raise ValueError(
                f"{kind!r} has no look: {', '.join(sorted(unknown))} is not among "
                f"{', '.join(sorted(CLASSES))} (sketch.CLASSES)"
            )
        name = start[1:].split(" ", 1)[0]
        end = "/>" if inner is None else f">{inner}</{name}>"
        self._parts.append(f'{start} class="{kind}"{end}')


def number(value: float) -> str:
    """A number as short as a picture needs it: two digits after the point at most.

    >>> number(3.0), number(-0.001), number(2.346)
    ('3', '0', '2.35')
    """
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
