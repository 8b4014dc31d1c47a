# style: fractions, rounded

from fractions import Fraction

(c0, r0), (c1, r1) = first, last
n = max(abs(c1 - c0), abs(r1 - r0))
for k in range(1, n + 1):
    cells.append(
        (round(Fraction(c0 * (n - k) + c1 * k, n)), round(Fraction(r0 * (n - k) + r1 * k, n)))
    )
