# style: recursion


def middle(number):
    return CELL / 2 if number == 0 else middle(number - 1) + CELL


x, y = middle(column), middle(row)
