# One cell and many readings
#
# Something stands in this cell. Each reading says "hit"
# or "passed", and is right more often than wrong. The
# chart follows two ways to put the readings together.

from bugbot import *
import math
import random

# Numbers to change
LOOKS = 20  # how many readings (1 to 200)
RIGHT = 70  # how many readings in 100 say "hit" (0 to 100)
L_OCC = 0.85  # log odds of a hit (0 to 2)
L_FREE = -0.4  # log odds of a pass (-2 to 0)

EDGES = [(60, 60), (140, 60), (140, 140), (60, 140), (60, 60)]
hits = 0
l = 0.0
for look in range(1, LOOKS + 1):
    if random.random() < RIGHT / 100:
        hits += 1
        l += L_OCC
    else:
        l += L_FREE
    p = 1 / (1 + math.exp(-l))
    plot("share of hits", hits / look)
    plot("added up", p)
    grey = round(255 * (1 - p))  # 0 is black
    draw("the cell", [(100, 100)], f"#{grey:02x}{grey:02x}{grey:02x}", "squares", 80)
    draw("its edge", EDGES, "black", "line", 1)
    wait(0.2)

print(f"{LOOKS} readings: {hits} hits, {LOOKS - hits} passes")
print(f"share of hits {hits / LOOKS:.2f}")
print(f"log odds {l:.2f}, so p = {p:.5f}")
