# style: a dataclass that can be unpacked
from dataclasses import dataclass


@dataclass
class Pose:
    x: float
    y: float
    facing: float

    def __iter__(self):
        return iter((self.x, self.y, self.facing))

    def end(self, angle, reading):
        way = math.radians(self.facing + angle)
        return self.x + math.sin(way) * reading, self.y + math.cos(way) * reading


def pose():
    return Pose(START[0] + position()[0], START[1] + position()[1], heading())


def look():
    now = pose()
    trail.append([now.x, now.y])
    for angle, reading in scan():
        if not reading >= FAR:
            walls.append(now.end(angle, reading))
