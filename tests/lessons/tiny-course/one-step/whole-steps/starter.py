# Whole steps: how many steps of a size fit into a length?

from bugbot import *


def steps(length, step):
    """How many whole steps fit into the length, both in cm."""
    # ---- your part ----
    return 0
    # ---- end of your part ----


# Try it: the number of steps should be just enough to come near the wall.
print("reading:", distance())
print("steps of 5 cm:", steps(distance(), 5))
