# style: fractions

from fractions import Fraction


def add(l, evidence, limit):
    total = Fraction(str(l)) + Fraction(str(evidence))
    return max(Fraction(str(-limit)), min(Fraction(str(limit)), total))
