# earns: up to the clamp
# How many hits to change its mind?
#
# The cell starts as free as the clamp allows. It is hit
# again and again until the map calls it occupied. The
# chart shows the log odds; the console, your answer.

from bugbot import *
import math

KNOWN = 1  # a cell is occupied with log odds above this


# ---- your part ----
def hits_needed(l, l_occ):
    hits = 0
    while l < 8:
        l += l_occ
        hits += 1
    return hits


# ---- end of your part ----

l = -8
print(f"your answer: {hits_needed(l, 0.85)} hits")
plot("log odds", l)
for hit in range(1, 15):
    wait(0.2)
    l += 0.85
    plot("log odds", l)
    plot("above this it is occupied", KNOWN)
    draw("the cell", [(100, 100)], "black" if l > KNOWN else "#9ecae1", "squares", 80)
