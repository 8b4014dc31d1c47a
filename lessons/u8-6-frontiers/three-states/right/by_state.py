# style: a dictionary of sets by state
from collections import defaultdict


def read_map(log_odds):
    found = defaultdict(set)
    for cell, l in log_odds.items():
        p = math.exp(l) / (1 + math.exp(l))
        found["free" if p < FREE_P else "occupied" if p > OCC_P else "unknown"].add(cell)
    return found["free"], found["occupied"]
