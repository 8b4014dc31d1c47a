# style: the mean of two edges

left, right = column * CELL, (column + 1) * CELL
bottom, top = row * CELL, (row + 1) * CELL
x, y = (left + right) / 2, (bottom + top) / 2
