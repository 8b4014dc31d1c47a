# style: a class for a cell


class Cell:
    def __init__(self, number):
        self.number = number

    def add(self, evidence):
        total = log_odds[self.number] + evidence
        log_odds[self.number] = total if abs(total) < L_MAX else math.copysign(L_MAX, total)


def add(cell, evidence):
    Cell(cell).add(evidence)


def add_beam(x, y, angle, reading):
    passed, hit = passed_and_hit(x, y, angle, reading)
    while passed:
        add(passed.pop(), L_FREE)
    if hit is not None:
        add(hit, L_OCC)


def watch():
    for name, (x, y) in WATCHED.items():
        column, row = int(x // CELL), int(y // CELL)
        plot(name, log_odds[row * ACROSS + column])
