# style: NumPy

import numpy as np


def add(cell, evidence):
    log_odds[cell] = float(np.clip(log_odds[cell] + evidence, -L_MAX, L_MAX))


def add_beam(x, y, angle, reading):
    passed, hit = passed_and_hit(x, y, angle, reading)
    for cell in np.array(passed, dtype=int):
        add(cell, L_FREE)
    if hit is not None:
        add(hit, L_OCC)


def watch():
    for name, point in WATCHED.items():
        cell = cell_at(point[0], point[1])
        plot(name, log_odds[cell])
