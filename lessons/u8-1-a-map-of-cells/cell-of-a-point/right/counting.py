# style: counting cells with while

column = 0
while (column + 1) * CELL <= x:
    column += 1
while column * CELL > x:
    column -= 1
row = 0
while (row + 1) * CELL <= y:
    row += 1
while row * CELL > y:
    row -= 1
