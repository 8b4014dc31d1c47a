# style: a list of evidence


def add(cell, evidence):
    log_odds[cell] = min(L_MAX, max(-L_MAX, log_odds[cell] + evidence))


def add_beam(x, y, angle, reading):
    passed, hit = passed_and_hit(x, y, angle, reading)
    evidence = [(cell, L_FREE) for cell in passed] + [
        (cell, L_OCC) for cell in [hit] if cell is not None
    ]
    for pair in evidence:
        add(*pair)


def watch():
    values = {name: log_odds[cell_at(x, y)] for name, (x, y) in WATCHED.items()}
    for name, value in values.items():
        plot(name, value)
