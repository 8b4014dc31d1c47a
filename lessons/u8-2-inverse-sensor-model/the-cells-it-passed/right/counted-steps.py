# style: a count of steps

for step in range(math.ceil((reading - CELL) / (CELL / 2))):
    cell = cell_of(*end_of_beam(x, y, angle, step * CELL / 2))
    if cell is not None:
        cells.append(cell)
