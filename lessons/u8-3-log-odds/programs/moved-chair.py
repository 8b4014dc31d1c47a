# A chair that is moved
#
# A chair stands in a cell and is hit at every look.
# Then somebody takes it away, and every look passes
# through the cell in two half-cell steps. How long does
# the map go on believing in the chair? One line is
# clamped, the other is not.

from bugbot import *

# Numbers to change
HITS = 60  # looks before the chair is taken away (1 to 150)
L_MAX = 8  # the clamp (2 to 60)
L_OCC = 0.85  # added by a hit (0.1 to 2)
L_FREE = -0.4  # added at each step of a pass (-2 to -0.1)
KNOWN = 1  # above this it is black (0.5 to 5)


def show(name, l, x):
    """A square for one cell, or none if it is unknown."""
    colour = "black" if l > KNOWN else "#9ecae1"
    draw(name, [] if abs(l) <= KNOWN else [(x, 100)], colour, "squares", 60)


print(f"looks at the chair: {HITS}")
clamped = unclamped = 0.0
free_after = {}
for look in range(1000):
    evidence = L_OCC if look < HITS else 2 * L_FREE
    unclamped += evidence
    clamped = max(-L_MAX, min(L_MAX, clamped + evidence))
    plot("clamped", clamped)
    plot("not clamped", unclamped)
    show("clamped cell", clamped, 60)
    show("unclamped cell", unclamped, 140)
    looks_since = look - HITS + 1
    if clamped < -KNOWN and "clamped" not in free_after:
        free_after["clamped"] = looks_since
    if unclamped < -KNOWN:
        free_after["not clamped"] = looks_since
        break
    wait(0.1)

print(f"with the clamp, free again after {free_after['clamped']} looks")
print(f"without it, free again after {free_after['not clamped']} looks")
