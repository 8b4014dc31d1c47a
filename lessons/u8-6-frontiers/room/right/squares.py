# style: squares of distances, and an early return
def has_room(cell, free, reach):
    c, r = cell
    for other_c in range(c - reach, c + reach + 1):
        for other_r in range(r - reach, r + reach + 1):
            square = ((other_c - c) * CELL) ** 2 + ((other_r - r) * CELL) ** 2
            if square < (SPARE + CELL / 2) ** 2 and (other_c, other_r) not in free:
                return False
    return True


def find_room(free):
    return set(cell for cell in free if has_room(cell, free, 4))
