# style: exact fractions, and walls as four more rectangles
from fractions import Fraction


def gap(x, y, real):
    walls = [(-9, -9, 9, MAT + 18), (MAT, -9, 9, MAT + 18)]
    walls += [(-9, -9, MAT + 18, 9), (-9, MAT, MAT + 18, 9)]
    squares = []
    for left, bottom, width, height in list(real) + walls:
        dx = max(Fraction(left) - Fraction(x), Fraction(0), Fraction(x) - left - width)
        dy = max(Fraction(bottom) - Fraction(y), Fraction(0), Fraction(y) - bottom - height)
        squares.append(dx**2 + dy**2)
    return math.sqrt(min(squares))


def wrong_percent(occupied, real):
    if len(occupied) < 1:
        return Fraction(0)
    return Fraction(100 * sum(gap(*p, real) > CELL for p in occupied), len(occupied))
