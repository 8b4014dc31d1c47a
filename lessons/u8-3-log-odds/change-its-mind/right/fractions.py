# style: fractions

from fractions import Fraction


def hits_needed(l, l_occ):
    l, l_occ = Fraction(str(l)), Fraction(str(l_occ))
    hits = 0
    while l <= KNOWN:
        l += l_occ
        hits += 1
    return hits
