# style: fractions

from fractions import Fraction

column = Fraction(x) // Fraction(CELL)
row = Fraction(y) // Fraction(CELL)
