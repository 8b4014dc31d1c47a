# style: all unknown cells one step away, by abs()
def find_frontier(free, occupied):
    def neighbours(cell):
        for c in range(ACROSS):
            for r in range(ACROSS):
                if abs(c - cell[0]) + abs(r - cell[1]) == 1:
                    yield c, r

    return {
        cell
        for cell in free
        if not all(each in free or each in occupied for each in neighbours(cell))
    }
