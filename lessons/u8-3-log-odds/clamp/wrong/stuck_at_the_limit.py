# earns: it stays there
# Clamp
#
# One cell. It is hit 30 times, and then beams pass
# through it for 60 half-cell steps. Watch what the
# clamp does to the line when your function has one.

from bugbot import *

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp


# ---- your part ----
def add(l, evidence, limit):
    if l >= limit:
        return limit
    if l <= -limit:
        return -limit
    return max(-limit, min(limit, l + evidence))


# ---- end of your part ----

l = 0.0
for n in range(90):
    l = add(l, L_OCC if n < 30 else L_FREE, L_MAX)
    plot("log odds", l)
    colour = "black" if l > 1 else "#9ecae1"
    draw("the cell", [(100, 100)] if abs(l) > 1 else [], colour, "squares", 80)
    wait(0.1)
print(f"at the end: {float(l):.2f}")
