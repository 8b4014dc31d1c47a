# Demo 4: binary maps and frontiers
#
# The robot maps what it sees, then drives to where free
# floor meets the unknown, and maps on from there.

from bugbot import *
import math

# Numbers to change
OCC_P = 0.65  # a cell is occupied when its probability is above this (0.5 to 0.99)
FREE_P = 0.35  # and free when it is below this (0.01 to 0.5)
MIN_REGION = 5  # frontier regions of fewer cells are left out (1 to 20)
SPARE = 6  # cm from the robot's middle to any wall, at least (5 to 9)

# The mat and the evidence as in demo 1, but each cell goes by its (column, row)
CELL, MAT, FAR = 5, 200, 170  # [cm]
START = (100, 25)
L_OCC, L_FREE, L_MAX = 0.85, -0.4, 8
log_odds = {(column, row): 0.0 for row in range(MAT // CELL) for column in range(MAT // CELL)}
CENTRE = {(c, r): ((c + 0.5) * CELL, (r + 0.5) * CELL) for c, r in log_odds}
BESIDE = {(c, r): {(c - 1, r), (c + 1, r), (c, r - 1), (c, r + 1)} for c, r in log_odds}


def cell_at(x, y):
    return math.floor(x / CELL), math.floor(y / CELL)


def add_beam(x, y, angle, reading):
    dx, dy = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    clear = reading - CELL if reading < FAR else FAR
    evidence = [(i * CELL / 2, L_FREE) for i in range(int(clear / (CELL / 2)))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        cell = cell_at(x + along * dx, y + along * dy)
        if cell in log_odds:
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def read_map():
    """The map as sets of cells: free, occupied, and the frontier; the rest is unknown."""
    free_below, occupied_above = (math.log(p / (1 - p)) for p in (FREE_P, OCC_P))  # log odds
    free = {cell for cell, l in log_odds.items() if l < free_below}
    occupied = {cell for cell, l in log_odds.items() if l > occupied_above}
    unknown = log_odds.keys() - free - occupied
    frontier = {cell for cell in free if BESIDE[cell] & unknown}
    return free, occupied, frontier


def find_regions(frontier):
    """Flood fill: the frontier cells in groups that hang together, without the small groups."""
    left, regions = set(frontier), []
    while left:
        region = [left.pop()]
        for cell in region:  # the list grows while we walk along it
            new = left & BESIDE[cell]
            region.extend(new)
            left -= new
        regions.append(region)
    return [region for region in regions if len(region) >= MIN_REGION]


def straight_way(start, goal, free, walls):
    """Is the line from start to goal over free cells only, with SPARE cm on every side?"""
    steps = math.ceil(math.dist(start, goal) / CELL)
    for i in range(1, steps + 1):
        x, y = (a + (b - a) * i / steps for a, b in zip(start, goal))
        gaps = [x, y, MAT - x, MAT - y] + [math.dist((x, y), wall) - CELL / 2 for wall in walls]
        if cell_at(x, y) not in free or min(gaps) < SPARE:
            return False
    return True


def choose_goal(start):
    """Middle of the nearest cell of a large enough region that can be reached, or None."""
    free, occupied, frontier = read_map()
    walls = [CENTRE[cell] for cell in occupied]
    goals = [CENTRE[cell] for region in find_regions(frontier) for cell in region]
    goals.sort(key=lambda goal: (math.dist(start, goal), goal))
    return next((goal for goal in goals if straight_way(start, goal, free, walls)), None)


def where():
    return START[0] + position()[0], START[1] + position()[1]


def keep_mapping(seconds):
    for tick in range(round(seconds * 10)):
        for angle, reading in scan():
            add_beam(*where(), heading() + angle, reading)
        if tick % 5 == 0:
            show()
        wait(0.1)
    stop()
    show()


def show():
    free, occupied, frontier = read_map()
    draw("free", [CENTRE[cell] for cell in sorted(free)], "#9ecae1", "squares", CELL)
    draw("occupied", [CENTRE[cell] for cell in sorted(occupied)], "black", "squares", CELL)
    draw("frontier", [CENTRE[cell] for cell in sorted(frontier)], "gold", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
    plot("frontier cells", len(frontier))


right(30)
keep_mapping(10)
here = where()
goal = choose_goal(here)
if goal is None:
    print("No frontier worth it can be reached in a straight line.")
else:
    draw("goal", [goal], "red", "dots", 5)
    bearing = math.degrees(math.atan2(goal[0] - here[0], goal[1] - here[1]))
    turn((bearing - heading() + 180) % 360 - 180)  # the shorter way round
    forward(100)  # 11.5 cm a second
    keep_mapping(math.dist(here, goal) / 11.5)
    right(30)
    keep_mapping(8)
