# style: the hit before the passes


def add(cell, evidence):
    log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + evidence))


def add_beam(x, y, angle, reading):
    passed, hit = passed_and_hit(x, y, angle, reading)
    if hit is not None:
        add(hit, L_OCC)
    for cell in passed:
        add(cell, L_FREE)


def watch():
    for name, (x, y) in WATCHED.items():
        plot(name, log_odds[cell_at(x, y)])
