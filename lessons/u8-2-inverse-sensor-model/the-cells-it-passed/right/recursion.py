# style: recursion


def walk(along):
    if along >= reading - CELL:
        return []
    cell = cell_of(*end_of_beam(x, y, angle, along))
    return ([] if cell is None else [cell]) + walk(along + CELL / 2)


cells = walk(0)
