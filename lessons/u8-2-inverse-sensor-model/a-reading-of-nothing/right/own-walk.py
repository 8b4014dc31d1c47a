# style: a walk of its own instead of cells_along

free = []
far = reading if reading < FAR else FAR + CELL
along = 0
while along < far - CELL:
    cell = cell_of(*end_of_beam(x, y, angle, along))
    if cell is not None:
        free.append(cell)
    along += CELL / 2
hit = cell_of(*end_of_beam(x, y, angle, reading)) if reading < FAR else None
