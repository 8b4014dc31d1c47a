# style: fractions

from fractions import Fraction

half = Fraction(1, 2)
x, y = (column + half) * CELL, (row + half) * CELL
