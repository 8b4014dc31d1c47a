# style: cells as lists

along = 0
while along < reading - CELL:
    px, py = end_of_beam(x, y, angle, along)
    column, row = int(px // CELL), int(py // CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        cells.append([column, row])
    along += CELL / 2
