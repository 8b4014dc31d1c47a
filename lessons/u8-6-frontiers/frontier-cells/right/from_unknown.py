# style: from the unknown cells to the free ones beside them
def find_frontier(free, occupied):
    frontier = set()
    for number in range(ACROSS * ACROSS):
        row, column = divmod(number, ACROSS)
        if (column, row) not in free and (column, row) not in occupied:
            frontier |= {(column + c, row + r) for c, r in SIDES} & free
    return frontier
