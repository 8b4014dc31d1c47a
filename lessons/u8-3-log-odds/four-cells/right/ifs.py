# style: two ifs


def add(cell, evidence):
    log_odds[cell] += evidence
    if log_odds[cell] > L_MAX:
        log_odds[cell] = L_MAX
    elif log_odds[cell] < -L_MAX:
        log_odds[cell] = -L_MAX


def add_beam(x, y, angle, reading):
    passed, hit = passed_and_hit(x, y, angle, reading)
    for cell in passed:
        add(cell, L_FREE)
    if hit is not None:
        add(hit, L_OCC)


def watch():
    for name in WATCHED:
        plot(name, log_odds[cell_at(*WATCHED[name])])
