# style: an early return

if reading >= FAR:
    return cells_along(x, y, angle, FAR), None
free = cells_along(x, y, angle, reading - CELL)
hit = cell_of(*end_of_beam(x, y, angle, reading))
