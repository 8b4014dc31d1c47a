# style: one near step after the other filters the set
def find_room(free):
    room = frozenset(free)
    n = 1 + int((SPARE + CELL / 2) // CELL)
    for c in range(-n, n + 1):
        for r in range(-n, n + 1):
            if (c * c + r * r) ** 0.5 < (SPARE + CELL / 2) / CELL:
                room &= {(column - c, row - r) for column, row in free}
    return room
