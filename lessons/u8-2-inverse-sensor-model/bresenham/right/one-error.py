# style: one error for both directions

dx, dy = abs(last[0] - column), -abs(last[1] - row)
sx = 1 if column < last[0] else -1
sy = 1 if row < last[1] else -1
err = dx + dy
while (column, row) != tuple(last):
    e2 = 2 * err
    if e2 >= dy:
        err += dy
        column += sx
    if e2 <= dx:
        err += dx
        row += sy
    cells.append((column, row))
