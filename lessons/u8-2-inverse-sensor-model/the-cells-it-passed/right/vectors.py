# style: a vector added at each step

a = math.radians(angle)
px, py = x, y
left = reading - CELL
while left > 0:
    cell = cell_of(px, py)
    if cell is not None:
        cells.append(cell)
    px += CELL / 2 * math.sin(a)
    py += CELL / 2 * math.cos(a)
    left -= CELL / 2
