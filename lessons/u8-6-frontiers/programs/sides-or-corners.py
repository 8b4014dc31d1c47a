# Sides or corners
#
# The robot looks round before the doorway and puts the
# frontier cells into regions. Regions of at least
# MIN_REGION cells are gold, smaller ones red.

from bugbot import *
import math

# Numbers to change
CORNERS = 0  # 1: cells that touch at a corner hang together too (0 to 1)
MIN_REGION = 5  # regions of fewer cells are small (1 to 20)

CELL, ACROSS, FAR, START = 5, 40, 170, (100, 25)
L_OCC, L_FREE, L_MAX, KNOWN = 0.85, -0.4, 8, 0.62
log_odds = {(column, row): 0.0 for row in range(ACROSS) for column in range(ACROSS)}


def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    dx, dy = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    clear = reading - CELL if reading < FAR else FAR
    evidence = [(i * CELL / 2, L_FREE) for i in range(int(clear / (CELL / 2)))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        cell = math.floor((x + along * dx) / CELL), math.floor((y + along * dy) / CELL)
        if cell in log_odds:
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def keep_mapping(seconds):
    for tick in range(round(seconds * 10)):
        for angle, reading in scan():
            add_beam(START[0], START[1] + position()[1], heading() + angle, reading)
        wait(0.1)
    stop()


def beside(cell, corners):
    """The cells round a cell: four, or eight with those at the corners."""
    column, row = cell
    steps = [(c, r) for c in (-1, 0, 1) for r in (-1, 0, 1) if corners or c == 0 or r == 0]
    return {(column + c, row + r) for c, r in steps}


def find_regions(cells):
    left, regions = set(cells), []
    while left:
        region = [min(left)]
        left.remove(region[0])
        for cell in region:  # the list grows while we walk along it
            new = beside(cell, CORNERS) & left
            region.extend(new)
            left -= new
        regions.append(region)
    return regions


def show(name, cells, colour):
    middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(cells)]
    draw(name, middles, colour, "squares", CELL)


right(60)
keep_mapping(5)
forward(100)
keep_mapping(7)
free = {cell for cell, l in log_odds.items() if l < -KNOWN}
occupied = {cell for cell, l in log_odds.items() if l > KNOWN}
unknown = log_odds.keys() - free - occupied
frontier = {cell for cell in free if beside(cell, 0) & unknown}
regions = find_regions(frontier)
large = [region for region in regions if len(region) >= MIN_REGION]
show("free", free, "#9ecae1")
show("occupied", occupied, "black")
show("small regions", frontier, "red")
show("large regions", set().union(*large), "gold")
print("frontier cells:", len(frontier))
print("regions:", len(regions))
print("large:", len(large))
print("the largest has:", max(len(region) for region in regions))
