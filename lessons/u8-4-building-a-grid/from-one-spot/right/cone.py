# style: a cone as wide as the gap between two beams, each of its cells once
SPREAD = (-2, 0, 2)  # degrees to both sides


def cell_at(x, y, way, along):
    column = math.floor((x + along * math.sin(way)) / CELL)
    row = math.floor((y + along * math.cos(way)) / CELL)
    return row * ACROSS + column if 0 <= column < ACROSS and 0 <= row < ACROSS else None


def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    nothing = reading >= FAR
    clear = FAR if nothing else reading - CELL
    floor, wall = set(), set()
    for off in SPREAD:
        way = math.radians(angle + off)
        floor |= {cell_at(x, y, way, i * CELL / 2) for i in range(int(clear * 2 / CELL))}
        if not nothing:
            wall.add(cell_at(x, y, way, reading))
    for cells, weight in ((floor - wall, L_FREE), (wall, L_OCC)):
        for cell in cells - {None}:
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def look():
    """Add one scan to the map, from where the robot is now."""
    x, y = START[0] + position()[0], START[1] + position()[1]
    for angle, reading in scan():
        add_beam(x, y, heading() + angle, reading)


def show():
    """Draw the map, and plot how much of it is known."""
    known = {True: [], False: []}
    for cell, l in enumerate(log_odds):
        if not -KNOWN <= l <= KNOWN:
            known[l > 0].append(centre(cell))
    draw("free", known[False], "#9ecae1", "squares", CELL)
    draw("occupied", known[True], "black", "squares", CELL)
    plot("known %", 100 * (len(known[True]) + len(known[False])) / len(log_odds))
