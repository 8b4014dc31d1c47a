# style: Bresenham's line to the hit, its last cell left out
def cell_at(x, y):
    return math.floor(x / CELL), math.floor(y / CELL)


def line(first, last):
    """The cells from one to the other, by whole numbers."""
    (column, row), (to_column, to_row) = first, last
    wide, high = abs(to_column - column), -abs(to_row - row)
    right = 1 if to_column > column else -1
    up = 1 if to_row > row else -1
    error = wide + high
    cells = [(column, row)]
    while (column, row) != (to_column, to_row):
        twice = 2 * error
        if twice >= high:
            error += high
            column += right
        if twice <= wide:
            error += wide
            row += up
        cells.append((column, row))
    return cells


def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    found = reading < FAR
    length = reading if found else FAR
    way = math.radians(angle)
    last = cell_at(x + length * math.sin(way), y + length * math.cos(way))
    cells = line(cell_at(x, y), last)
    if found:
        cells.pop()
    for column, row in cells:
        if column in range(ACROSS) and row in range(ACROSS):
            cell = row * ACROSS + column
            log_odds[cell] = max(log_odds[cell] + L_FREE, -L_MAX)
    column, row = last
    if found and column in range(ACROSS) and row in range(ACROSS):
        cell = row * ACROSS + column
        log_odds[cell] = min(log_odds[cell] + L_OCC, L_MAX)


def look():
    """Add one scan to the map, from where the robot is now."""
    x, y = position()
    x += START[0]
    y += START[1]
    for angle, reading in scan():
        add_beam(x, y, (heading() + angle) % 360, reading)


def show():
    """Draw the map, and plot how much of it is known."""
    free, occupied = [], []
    for cell in range(ACROSS**2):
        if log_odds[cell] < -KNOWN:
            free.append(centre(cell))
        elif log_odds[cell] > KNOWN:
            occupied.append(centre(cell))
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", (len(free) + len(occupied)) / 16)
