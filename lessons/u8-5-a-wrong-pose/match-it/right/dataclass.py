# style: a dataclass, with sine and cosine of its own
from dataclasses import astuple, dataclass


@dataclass
class Pose:
    x: float
    y: float
    facing: float

    def place(self, ahead, right):
        s, c = math.sin(math.radians(self.facing)), math.cos(math.radians(self.facing))
        return self.x + ahead * s + right * c, self.y + ahead * c - right * s

    def fit(self, field, hits):
        cells = {(c, r): field[r * ACROSS + c] for c in range(ACROSS) for r in range(ACROSS)}
        found = []
        for ahead, right in hits:
            px, py = self.place(ahead, right)
            found.append(cells.get((math.floor(px / CELL), math.floor(py / CELL)), 0))
        return sum(found) / len(found)


def fit(field, x, y, facing, hits):
    return Pose(x, y, facing).fit(field, hits)


def match(field, x, y, facing, hits):
    tried = []
    for turn in TURNS:
        for dx in SHIFTS:
            for dy in SHIFTS:
                tried.append(Pose(x + dx, y + dy, facing + turn))
    return list(astuple(max(tried, key=lambda pose: pose.fit(field, hits))))
