# style: a dataclass for things that stand there
from dataclasses import dataclass


@dataclass(frozen=True)
class Thing:
    left: float
    bottom: float
    width: float
    height: float

    def gap(self, x, y):
        near_x = min(max(x, self.left), self.left + self.width)
        near_y = min(max(y, self.bottom), self.bottom + self.height)
        return math.dist((x, y), (near_x, near_y))


def gap(x, y, real):
    things = [Thing(*each) for each in real]
    return min([x, MAT - x, y, MAT - y] + [thing.gap(x, y) for thing in things])


def wrong_percent(occupied, real):
    wrong = 0
    for x, y in occupied:
        if gap(x, y, real) > CELL:
            wrong += 1
    return wrong * 100 / len(occupied) if occupied else 0
