# style: a class that keeps the list, and goes on until it has passed the hit's cell
class Grid:
    def __init__(self, cells):
        self.cells = cells

    def change(self, x, y, weight):
        column, row = int(x // CELL), int(y // CELL)
        if min(column, row) < 0 or max(column, row) >= ACROSS:
            return
        place = column + ACROSS * row
        self.cells[place] = sorted((-L_MAX, self.cells[place] + weight, L_MAX))[1]


grid = Grid(log_odds)


def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    way = math.radians(90 - angle)
    nothing = reading >= FAR
    clear, along = FAR if nothing else reading - CELL, 0
    while along < clear:
        grid.change(x + along * math.cos(way), y + along * math.sin(way), L_FREE)
        along += CELL / 2
    if not nothing:
        grid.change(x + reading * math.cos(way), y + reading * math.sin(way), L_OCC)


def look():
    """Add one scan to the map, from where the robot is now."""
    here, facing = position(), heading()
    x, y = (a + b for a, b in zip(START, here))
    for angle, reading in scan():
        add_beam(x, y, facing + angle, reading)


def show():
    """Draw the map, and plot how much of it is known."""
    free = [centre(i) for i, l in enumerate(grid.cells) if l + KNOWN < 0]
    occupied = [centre(i) for i, l in enumerate(grid.cells) if l - KNOWN > 0]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
