# style: match

match cell_of(x, y):
    case (column, row) if 0 <= column < ACROSS and 0 <= row < ACROSS:
        index = column + row * ACROSS
    case _:
        index = None
