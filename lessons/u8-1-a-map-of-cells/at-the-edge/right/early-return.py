# style: an early return, and range()

column, row = cell_of(x, y)
if column not in range(ACROSS) or row not in range(ACROSS):
    return None
return ACROSS * row + column
