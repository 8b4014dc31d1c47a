# style: the steps of each cell counted first, then added at once
from collections import Counter


def add_beam(log_odds, x, y, angle, reading):
    def cell_at(d):
        c = int((x + d * math.sin(math.radians(angle))) // CELL)
        r = int((y + d * math.cos(math.radians(angle))) // CELL)
        return (c, r) if c in range(ACROSS) and r in range(ACROSS) else None

    limit = FAR if reading >= FAR else max(reading - CELL, 0)
    steps = Counter()
    i = 0
    while i * CELL / 2 < limit:
        steps[cell_at(i * CELL / 2)] += 1
        i += 1
    del steps[None]
    for (c, r), times in steps.items():
        old = log_odds[r * ACROSS + c]
        log_odds[r * ACROSS + c] = max(old + times * L_FREE, -L_MAX)
    end = cell_at(reading)
    if reading < FAR and end:
        log_odds[end[1] * ACROSS + end[0]] = min(log_odds[end[1] * ACROSS + end[0]] + L_OCC, L_MAX)
