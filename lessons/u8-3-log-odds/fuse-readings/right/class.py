# style: a class for a cell


class Cell:
    def __init__(self):
        self.l = 0.0

    def add(self, p):
        self.l += log_odds(p)
        return self


def fuse(readings):
    cell = Cell()
    for p in readings:
        cell.add(p)
    return probability(cell.l)
