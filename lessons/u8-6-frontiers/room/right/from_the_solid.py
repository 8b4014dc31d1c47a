# style: a disc taken away round every cell that is not free
def find_room(free):
    wide = int(SPARE / CELL) + 2
    solid = {
        (c, r)
        for c in range(-wide, ACROSS + wide)
        for r in range(-wide, ACROSS + wide)
        if (c, r) not in free
    }
    room = set(free)
    for c, r in solid:
        for i in range(-wide, wide + 1):
            for j in range(-wide, wide + 1):
                if CELL * hypot(i, j) < SPARE + CELL / 2:
                    room.discard((c + i, r + j))
    return room
