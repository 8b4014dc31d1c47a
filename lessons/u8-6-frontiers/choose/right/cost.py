# style: the least cost in place of the greatest worth
import math


def nearest_cell(here, region):
    away = {cell: math.dist(here, cell) for cell in region}
    return min(away, key=away.get)


def choose(here, regions, gain):
    try:
        return min(
            (nearest_cell(here, each) for each in regions),
            key=lambda cell: dist(here, cell) - gain * len(next(r for r in regions if cell in r)),
        )
    except ValueError:
        return None
