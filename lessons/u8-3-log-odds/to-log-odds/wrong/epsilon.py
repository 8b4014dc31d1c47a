# earns: 0.847296
# From p to l and back
#
# In this program p climbs from 0.01 to 0.99. The chart
# shows p, and p turned into log odds and back again.
# When both functions work, the two lines lie on each
# other. The curve on the mat shows the log odds of each
# p.

from bugbot import *
import math


# ---- your part ----
def log_odds(p):
    return math.log((p + 1e-6) / (1 - p + 1e-6))


def probability(l):
    return 1 / (1 + math.exp(-l))


# ---- end of your part ----

curve = []
for n in range(1, 100):
    p = n / 100
    l = log_odds(p)
    plot("p", p)
    plot("there and back", probability(l))
    curve.append((200 * p, 100 + 18 * l))
    draw("log odds", curve, "black", "dots", 2)
    wait(0.1)

for p in (0.1, 0.4, 0.5, 0.7, 0.9):
    print(f"log_odds({p}) gives {log_odds(p):.2f}")
