# style: a search through all places

index = None
for place in range(ACROSS * ACROSS):
    row, column = divmod(place, ACROSS)
    if column * CELL <= x < (column + 1) * CELL and row * CELL <= y < (row + 1) * CELL:
        index = place
