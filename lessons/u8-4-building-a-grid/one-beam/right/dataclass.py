# style: a dataclass for a beam, with a generator of its evidence
from dataclasses import dataclass


@dataclass
class Beam:
    x: float
    y: float
    angle: float
    reading: float

    @property
    def is_hit(self):
        return self.reading < FAR

    def place(self, cm):
        turned = math.pi * self.angle / 180
        return self.x + cm * math.sin(turned), self.y + cm * math.cos(turned)

    def evidence(self):
        steps = math.ceil(((self.reading - CELL) if self.is_hit else FAR) / (CELL / 2))
        for step in range(steps):
            yield self.place(step * CELL / 2), L_FREE
        if self.is_hit:
            yield self.place(self.reading), L_OCC


def add_beam(log_odds, x, y, angle, reading):
    for (px, py), weight in Beam(x, y, angle, reading).evidence():
        column, row = divmod(px, CELL)[0], divmod(py, CELL)[0]
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            cell = int(row * ACROSS + column)
            log_odds[cell] = min(max(log_odds[cell] + weight, -L_MAX), L_MAX)
