# style: the free cells as a set

free = set(cells_along(x, y, angle, FAR if reading >= FAR else reading - CELL))
hit = cell_of(*end_of_beam(x, y, angle, reading)) if not reading >= FAR else None
