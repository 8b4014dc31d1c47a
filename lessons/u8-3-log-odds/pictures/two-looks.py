"""A hundred cells, looked at twice: odds of 1 to 1, 7 to 3, 49 to 9."""

from sketch import Drawing

RIGHT = 0.7
SIDE = 9  # units a cell
PANELS = ((8, "at first"), (125, "one hit"), (242, "two hits"))


def picture() -> str:
    """The picture as one <svg>."""
    drawing = Drawing(
        340,
        170,
        "A hundred cells, looked at twice",
        "Three groups of cells. At first 50 are occupied and 50 free. Those with one hit: 35 "
        "occupied and 15 free. Those with two hits: 24.5 occupied and 4.5 free.",
    )
    occupied, free = 50.0, 50.0
    for left, words in PANELS:
        drawing.text(left + 5 * SIDE, 14, words, "strong middle")
        panel = drawing.plane(left, 22, scale=SIDE, width_cm=10, height_cm=10)
        panel.ground()
        for number in range(100):
            column, row = number % 10, number // 10
            black = max(0.0, min(1.0, occupied - number))
            blue = max(0.0, min(1.0, occupied + free - number)) - black
            if black > 0:
                panel.rectangle((column, row), black, 1, "occupied")
            if blue > 0:
                panel.rectangle((column + black, row), blue, 1, "free")
        panel.grid(1)
        drawing.text(left + 5 * SIDE, 128, f"{occupied:g} to {free:g}", "middle")
        p = occupied / (occupied + free)
        drawing.text(left + 5 * SIDE, 144, f"p = {p:.2f}", "middle soft")
        occupied, free = occupied * RIGHT, round(free * (1 - RIGHT), 3)
    for left, _ in PANELS[1:]:
        drawing.text(left - 14, 70, "→", "middle strong")
    drawing.text(8, 164, "black: occupied; light blue: free", "small soft")
    return drawing.svg()
