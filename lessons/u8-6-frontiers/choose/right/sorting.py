# style: sorted, and the last one taken where two are worth the same
from math import hypot


def nearest_cell(here, region):
    return sorted(region, key=lambda c: hypot(c[0] - here[0], c[1] - here[1]))[0]


def choose(here, regions, gain):
    ranked = sorted(
        (gain * len(each) - dist(here, nearest_cell(here, each)), i)
        for i, each in enumerate(regions)
    )
    return nearest_cell(here, regions[ranked[-1][1]]) if ranked else None
