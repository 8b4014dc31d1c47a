# style: a walk that stops at the edge of the mat

along = 0
while along < reading - CELL:
    cell = cell_of(*end_of_beam(x, y, angle, along))
    if cell is None:
        break
    cells.append(cell)
    along += CELL / 2
