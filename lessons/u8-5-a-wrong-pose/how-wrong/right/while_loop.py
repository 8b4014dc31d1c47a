# style: while loops, the square root only at the end
def gap(x, y, real):
    walls = x
    if MAT - x < walls:
        walls = MAT - x
    if y < walls:
        walls = y
    if MAT - y < walls:
        walls = MAT - y
    least = walls * walls
    n = 0
    while n < len(real):
        left, bottom = real[n][0], real[n][1]
        right, top = left + real[n][2], bottom + real[n][3]
        dx = 0
        if x < left:
            dx = left - x
        elif x > right:
            dx = x - right
        dy = 0
        if y < bottom:
            dy = bottom - y
        elif y > top:
            dy = y - top
        least = min(least, dx * dx + dy * dy)
        n += 1
    return least**0.5


def wrong_percent(occupied, real):
    wrong, black = 0, list(occupied)
    total = len(black)
    while black:
        x, y = black.pop()
        if not gap(x, y, real) <= CELL:
            wrong += 1
    try:
        return wrong * 100 / total
    except ZeroDivisionError:
        return 0
