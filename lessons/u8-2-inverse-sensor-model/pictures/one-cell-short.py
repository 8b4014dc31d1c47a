"""Why the walk along a beam stops one cell short of the hit."""

from math import exp

from sketch import Drawing

CELL = 5
WALL, READING, NOISE = 50, 52, 2


def picture() -> str:
    """A beam towards a wall, the spread of its readings, and where the walk stops."""
    stop = READING - CELL
    drawing = Drawing(
        340,
        236,
        "One cell short of the hit",
        f"A wall begins {WALL} cm from the robot. A curve like a bell shows how readings spread "
        f"about it, mostly within 4 cm. One reading is {READING} cm, a little too far. The walk "
        f"along the beam stops {CELL} cm before the reading, at {stop} cm, in front of the wall. "
        "Walked right up to the reading, it would have gone into the wall.",
    )
    view = drawing.plane(8, 92, scale=10.8, width_cm=30, height_cm=7, origin=(32, -3.5))
    view.ground()
    view.rectangle((WALL, -3.5), 12, 7, "truth")
    view.rectangle((32, -2.5), 13, 5, "free")
    for line in range(35, 62, CELL):
        view.line((line, -2.5), (line, 2.5), "grid")
    view.line((32, 0), (stop, 0), "beam")
    view.line((stop, 0), (READING, 0), "rest")
    for step in range(5):
        view.dot((34.5 + step * CELL / 2, 0), 4, "step")
    view.cross((READING, 0), 5)
    view.text((WALL + 8.5, 0), "wall", "on-mat middle", down=4)
    view.text((40, -2.5), "free", "on-mat middle", down=-6)

    bell = drawing.plane(8, 12, scale=10.8, width_cm=30, height_cm=1, origin=(32, 0), scale_y=70)
    places = [WALL - 6 + i / 5 for i in range(61)]
    bell.curve([(x, exp(-(((x - WALL) / NOISE) ** 2) / 2)) for x in places], "curve")
    bell.line((32, 0), (62, 0), "axis")
    drawing.text(12, 26, "how often the sensor", "soft")
    drawing.text(12, 42, "reads each distance", "soft")

    for at, words, kind in ((stop, "the walk stops", "end"), (READING, "reading", "ink")):
        x, y = view.on_sheet((at, -3.5))
        drawing.line(view.on_sheet((at, 0)), (x, y + 22), "guide")
        drawing.text(x + (4 if at == stop else -4), y + 36, words, kind)
    middle, y = view.on_sheet(((stop + READING) / 2, -3.5))
    drawing.text(middle, y + 15, "one cell", "soft small middle")
    for at in (35, 40, 45, WALL, 55, 60):
        x, y = view.on_sheet((at, -3.5))
        drawing.text(x, y + 56, f"{at} cm" if at == 35 else str(at), "soft small middle")
    return drawing.svg()
