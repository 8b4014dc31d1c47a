# style: bisect over the two limits, exact fractions
from bisect import bisect
from fractions import Fraction


def image_rows(log_odds, across):
    limits = [math.log(0.35 / 0.65), math.log(0.65 / 0.35)]
    greys = [(254, 205, 0)[bisect(limits, l)] for l in log_odds]
    rows = [greys[i : i + across] for i in range(0, len(greys), across)]
    rows.reverse()
    return rows


def settings(image, cell_cm):
    return {
        "free_thresh": Fraction(196, 1000),
        "image": image,
        "occupied_thresh": Fraction(65, 100),
        "negate": 0,
        "origin": [0, 0, 0],
        "resolution": Fraction(cell_cm) / 100,
    }
