# style: map() with angles and readings apart
from functools import partial


def add_scan(log_odds, x, y, facing, readings):
    angles, distances = zip(*readings)
    turned = map(lambda angle: facing + angle, angles)
    list(map(partial(add_beam, log_odds, x, y), turned, distances))
