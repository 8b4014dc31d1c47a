# style: a Counter of the passed cells

from collections import Counter


def add(cell, evidence):
    log_odds[cell] = sorted((-L_MAX, log_odds[cell] + evidence, L_MAX))[1]


def add_beam(x, y, angle, reading):
    passed, hit = passed_and_hit(x, y, angle, reading)
    for cell, times in Counter(passed).items():
        add(cell, times * L_FREE)
    if hit is not None:
        add(hit, L_OCC)


def watch():
    [plot(name, log_odds[cell_at(*point)]) for name, point in WATCHED.items()]
