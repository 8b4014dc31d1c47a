# style: every crossed cell once, from line to line
import itertools


def crossed(x, y, angle, length):
    """The cells that a line goes through, each once, from its first to its last."""
    dx, dy = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    cuts = {0.0, length}
    for start, way in ((x, dx), (y, dy)):
        if abs(way) < 1e-9:
            continue
        low, high = sorted((start, start + way * length))
        for line in range(math.ceil(low / CELL), math.floor(high / CELL) + 1):
            cuts.add((line * CELL - start) / way)
    cuts = sorted(cuts)
    middles = [(a + b) / 2 for a, b in itertools.pairwise(cuts) if b - a > 1e-9]
    return [(math.floor((x + m * dx) / CELL), math.floor((y + m * dy) / CELL)) for m in middles]


def change(cell, by):
    column, row = cell
    if not (0 <= column < ACROSS and 0 <= row < ACROSS):
        return
    number = row * ACROSS + column
    log_odds[number] = min(L_MAX, max(-L_MAX, log_odds[number] + by))


def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    found = reading < FAR
    clear = max(0, reading - CELL) if found else FAR
    for cell in crossed(x, y, angle, clear):
        change(cell, L_FREE)
    if found:
        way = math.radians(angle)
        end = x + reading * math.sin(way), y + reading * math.cos(way)
        change((math.floor(end[0] / CELL), math.floor(end[1] / CELL)), L_OCC)


def look():
    """Add one scan to the map, from where the robot is now."""
    (dx, dy), facing = position(), heading()
    for angle, reading in scan():
        add_beam(START[0] + dx, START[1] + dy, facing + angle, reading)


def show():
    """Draw the map, and plot how much of it is known."""
    layers = {"free": [], "occupied": []}
    for cell, l in enumerate(log_odds):
        if abs(l) > KNOWN:
            layers["free" if l < 0 else "occupied"].append(centre(cell))
    draw("free", layers["free"], "#9ecae1", "squares", CELL)
    draw("occupied", layers["occupied"], "black", "squares", CELL)
    plot("known %", 100 * sum(map(len, layers.values())) / len(log_odds))
