# style: the nearest solid cell, by min() over middles
from math import dist


def find_room(free):
    def middle(cell):
        return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL

    around = [(c, r) for c in range(-4, 5) for r in range(-4, 5)]
    room = set()
    for cell in free:
        solid = [(cell[0] + c, cell[1] + r) for c, r in around]
        gaps = [dist(middle(cell), middle(each)) for each in solid if each not in free]
        if not gaps or min(gaps) >= SPARE + CELL / 2:
            room.add(cell)
    return room
