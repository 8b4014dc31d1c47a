# style: fractions

from fractions import Fraction

count = math.ceil(Fraction(MAT, side)) ** 2
