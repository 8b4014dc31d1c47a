# Probability and log odds
#
# The curve on the mat turns one into the other: p runs
# from 0 at the left edge to 1 at the right edge, and
# log odds run upwards, with 0 half way up.

from bugbot import *
import math

# A number to change
P = 0.7  # the probability to mark on the curve (0.01 to 0.99)


def log_odds(p):
    return math.log(p / (1 - p))


def place(p):
    """The curve's point for p: 18 cm up for each 1 of l."""
    return 200 * p, 100 + 18 * log_odds(p)


draw("log odds 0", [(0, 100), (200, 100)], "grey", "line", 0.6)
draw("curve", [place(n / 200) for n in range(2, 199)], "black", "line", 1)
draw("P", [place(P)], "red", "dots", 6)
draw("scale", [(20, 104, "l = 0"), (20, 194, "l = 5"), (20, 12, "l = -5")], "grey", "text", 8)
draw("P down to p", [(200 * P, 0), place(P)], "red", "line", 0.6)

for p in (0.01, 0.1, 0.3, 0.4, 0.5, 0.6, 0.7, 0.9, 0.99):
    print(f"p {p:.2f}, odds {p / (1 - p):.2f}, log odds {log_odds(p):.2f}")
print(f"P = {P:.2f} has odds {P / (1 - P):.2f} and log odds {log_odds(P):.2f}")
for l in (1, 8):
    print(f"log odds of {l} are p = {1 / (1 + math.exp(-l)):.5f}")
