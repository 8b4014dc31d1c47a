# style: recursion


def cells_for(length):
    return 0 if length <= 0 else 1 + cells_for(length - side)


count = cells_for(MAT) ** 2
