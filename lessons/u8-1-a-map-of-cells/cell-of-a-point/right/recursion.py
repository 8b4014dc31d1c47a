# style: recursion


def cells_before(value):
    if value < 0:
        return cells_before(value + CELL) - 1
    if value < CELL:
        return 0
    return cells_before(value - CELL) + 1


column, row = cells_before(x), cells_before(y)
