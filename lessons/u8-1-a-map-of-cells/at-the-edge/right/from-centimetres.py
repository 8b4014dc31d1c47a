# style: the edges in centimetres

if not (0 <= x < CELL * ACROSS and 0 <= y < CELL * ACROSS):
    return None
return int(y // CELL) * ACROSS + int(x // CELL)
