# style: a dataclass for a beam

from dataclasses import dataclass


@dataclass
class Beam:
    angle: float
    reading: float

    def direction(self):
        return self.angle + heading()


x, y = START[0] + position()[0], START[1] + position()[1]
for beam in [Beam(*pair) for pair in scan()]:
    passed, hit = beam_says(x, y, beam.direction(), beam.reading)
    free.update(passed)
    if hit is not None:
        hits.add(hit)
