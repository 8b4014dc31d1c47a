# style: its own walk along the beam, as long as it is nearer than the clear length
def add(cell, evidence):
    log_odds[cell] = min(L_MAX, max(-L_MAX, log_odds[cell] + evidence))


def add_where(x, y, way, along, evidence):
    cell = cell_at(x + along * math.sin(way), y + along * math.cos(way))
    if cell is not None:
        add(cell, evidence)


def add_beam(x, y, angle, reading):
    way, along = math.radians(angle), 0
    clear = FAR if reading >= FAR else reading - CELL
    while along < clear:
        add_where(x, y, way, along, L_FREE)
        along += CELL / 2
    if reading < FAR:
        add_where(x, y, way, reading, L_OCC)


def watch():
    for name, place in WATCHED.items():
        plot(name, log_odds[cell_at(*place)])
