# style: int(), put right for negative numbers


def down(value):
    whole = int(value / CELL)
    return whole - 1 if whole * CELL > value else whole


column, row = down(x), down(y)
