# style: steps of a third of a cell, each of them evidence
def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    way = math.radians(angle)
    found = reading < FAR
    third = CELL / 3
    steps = int((reading - CELL if found else FAR) / third)
    for number in range(steps):
        change(x, y, way, number * third, L_FREE)
    if found:
        change(x, y, way, reading, L_OCC)


def change(x, y, way, along, weight):
    column = math.floor((x + along * math.sin(way)) / CELL)
    row = math.floor((y + along * math.cos(way)) / CELL)
    if column in range(ACROSS) and row in range(ACROSS):
        cell = column + row * ACROSS
        log_odds[cell] = min(max(log_odds[cell] + weight, -L_MAX), L_MAX)


def look():
    """Add one scan to the map, from where the robot is now."""
    (right, up), facing = position(), heading()
    for angle, reading in scan():
        add_beam(START[0] + right, START[1] + up, facing + angle, reading)


def show():
    """Draw the map, and plot how much of it is known."""
    free, occupied = [], []
    for cell, l in enumerate(log_odds):
        if l < -KNOWN:
            free.append(centre(cell))
        elif l > KNOWN:
            occupied.append(centre(cell))
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
