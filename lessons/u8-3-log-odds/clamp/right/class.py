# style: a class with a property


class Cell:
    def __init__(self, l, limit):
        self.limit = limit
        self.l = l

    @property
    def clamped(self):
        return min(self.limit, max(-self.limit, self.l))


def add(l, evidence, limit):
    return Cell(l + evidence, limit).clamped
