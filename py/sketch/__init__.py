"""Drawing the lessons' pictures: SVG from numbers, at build time only.

May import: the standard library, `bugbot.frames`. It is not in the browser's snapshot and no
learner's program can import it; a lesson's `pictures/NAME.py` does, beside `mapping`:

    from sketch import Drawing

    def picture() -> str:
        drawing = Drawing(340, 120, "A title", "What one sees, for those who don't.")
        mat = drawing.plane(10, 10, scale=3, width_cm=60, height_cm=30)
        mat.cells([(0, 0), (1, 0)], "free", cell_cm=5)
        mat.line((2.5, 2.5), (50, 20), "beam")
        drawing.text(10, 112, "said under it", "soft")
        return drawing.svg()

    drawing.py   the sheet: shapes and words, in units of the picture, y down the page
    plane.py     a window on the mat (or a chart) on that sheet: its own units, y up

A picture is 340 units wide, so that on a phone a unit is a pixel; words are 13 units high,
small ones 12. Colours, dashes and fonts belong to the classes in `site/src/page/sketch.css`:
`drawing.CLASSES` lists them, and any other is an error. A colour never stands alone: a word, a
pattern or a mark says the same.
"""

from sketch.drawing import CLASSES, Drawing
from sketch.plane import Plane

__all__ = ["CLASSES", "Drawing", "Plane"]
