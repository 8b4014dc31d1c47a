# style: recursion from cell to cell
def find_regions(cells):
    left = cells.copy()

    def gather(cell, region):
        left.discard(cell)
        region.add(cell)
        for c in (-1, 0, 1):
            for r in (-1, 0, 1):
                neighbour = (cell[0] + c, cell[1] + r)
                if neighbour in left:
                    gather(neighbour, region)
        return region

    found = []
    for cell in cells:
        if cell in left:
            found.append(gather(cell, set()))
    return found
