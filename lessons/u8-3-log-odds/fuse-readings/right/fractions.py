# style: fractions

from fractions import Fraction


def fuse(readings):
    odds = Fraction(1)
    for p in readings:
        q = Fraction(str(p))
        odds *= q / (1 - q)
    return odds / (1 + odds)
