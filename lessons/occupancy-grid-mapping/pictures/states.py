"""Probabilities cut by one threshold and by two, with the greys of a map file."""

from mapping.frontiers import FREE_P, OCC_P
from sketch import Drawing


def picture() -> str:
    drawing = Drawing(
        340,
        186,
        "Two states and three",
        "A line of probabilities from 0 to 1, twice. Above, one threshold at 0.5 cuts it into free "
        f"and occupied. Below, two thresholds, {FREE_P} and {OCC_P}, leave a middle part that is "
        "unknown. Under the three parts stand the greys of a map file: 254, 205 and 0.",
    )
    drawing.text(5, 14, "One threshold", "ink strong")
    bar(drawing, 22, [(0, 0.5, "free", "free"), (0.5, 1, "occupied", "occupied")])
    drawing.text(170, 66, "0.5", "soft small middle")
    drawing.text(5, 90, "Two thresholds", "ink strong")
    parts = [
        (0, FREE_P, "free", "free"),
        (FREE_P, OCC_P, "mat", "unknown"),
        (OCC_P, 1, "occupied", "occupied"),
    ]
    bar(drawing, 98, parts)
    for p in (FREE_P, OCC_P):
        drawing.text(5 + 330 * p, 142, f"{p}", "soft small middle")
    drawing.text(5, 142, "p = 0", "soft small")
    drawing.text(335, 142, "p = 1", "soft small end")
    drawing.text(170, 180, "the grey of each in a map file", "soft small middle")
    for (start, end, _, _), grey in zip(parts, ("254", "205", "0"), strict=True):
        drawing.text(5 + 330 * (start + end) / 2, 162, grey, "code middle")
    return drawing.svg()


def bar(drawing: Drawing, top: float, parts: list[tuple[float, float, str, str]]) -> None:
    """The line from 0 to 1 in parts: from, to, look, word."""
    for start, end, kind, word in parts:
        drawing.rectangle((5 + 330 * start, top), 330 * (end - start), 30, kind)
        words = "on-black middle" if kind == "occupied" else "on-mat middle"
        drawing.text(5 + 330 * (start + end) / 2, top + 19.5, word, words)
