# Demo 4: binary maps and frontiers
#
# The robot maps what it can see, sorts the cells into free, occupied and
# unknown, and drives to the nearest place where free floor meets the unknown.

from bugbot import *
import math

# Numbers to change
OCC_P = 0.65  # a cell is occupied when its probability is above this (0.5 to 0.99)
FREE_P = 0.35  # and free when it is below this (0.01 to 0.5)
MIN_REGION = 5  # frontier regions of fewer cells are left out (1 to 20)
SPARE = 6  # cm from the robot's middle to any wall, at least (5 to 9)

# The mat and the evidence, as in demo 1
CELL, MAT, FAR = 5, 200, 170  # [cm]
START = (100, 25)
L_OCC, L_FREE, L_MAX = 0.85, -0.4, 8
ACROSS = math.ceil(MAT / CELL)
log_odds = [0.0] * (ACROSS * ACROSS)
CENTRES = [
    ((column + 0.5) * CELL, (row + 0.5) * CELL) for row in range(ACROSS) for column in range(ACROSS)
]


def add_beam(x, y, angle, reading):
    dx, dy = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    clear = reading - CELL if reading < FAR else FAR
    evidence = [(i * CELL / 2, L_FREE) for i in range(int(clear / (CELL / 2)))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        column, row = math.floor((x + along * dx) / CELL), math.floor((y + along * dy) / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            cell = row * ACROSS + column
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def beside(cell):
    """The cells to the left and right of a cell, below and above it."""
    column, row = cell % ACROSS, cell // ACROSS
    around = ((column - 1, row), (column + 1, row), (column, row - 1), (column, row + 1))
    return [r * ACROSS + c for c, r in around if 0 <= c < ACROSS and 0 <= r < ACROSS]


BESIDE = [beside(cell) for cell in range(len(log_odds))]  # worked out once


def read_map():
    """The map as sets of cells: free, occupied, and the frontier; the rest is unknown."""
    free_below = math.log(FREE_P / (1 - FREE_P))  # the thresholds as log odds
    occupied_above = math.log(OCC_P / (1 - OCC_P))
    free = {cell for cell, l in enumerate(log_odds) if l < free_below}
    occupied = {cell for cell, l in enumerate(log_odds) if l > occupied_above}
    unknown = set(range(len(log_odds))) - free - occupied
    frontier = {near for cell in unknown for near in BESIDE[cell] if near in free}
    return free, occupied, frontier


def find_regions(frontier):
    """Flood fill: the frontier cells in groups that hang together."""
    left, regions = set(frontier), []
    while left:
        region = [left.pop()]
        for cell in region:  # the list grows while we walk along it
            new = left.intersection(BESIDE[cell])
            region.extend(new)
            left -= new
        regions.append(region)
    return regions


def straight_way(start, goal, free, walls):
    """Is the line from start to goal over free cells only, with SPARE cm on every side?"""
    steps = math.ceil(math.dist(start, goal) / CELL)
    for i in range(1, steps + 1):
        x, y = (a + (b - a) * i / steps for a, b in zip(start, goal))
        on_free = math.floor(y / CELL) * ACROSS + math.floor(x / CELL) in free
        if not on_free or min(x, y, MAT - x, MAT - y) < SPARE:
            return False
        if any(math.dist((x, y), wall) < SPARE + CELL / 2 for wall in walls):
            return False
    return True


def choose_goal(start):
    """Middle of the nearest cell of a large enough region that can be reached, or None."""
    free, occupied, frontier = read_map()
    walls = [CENTRES[cell] for cell in occupied]
    regions = [region for region in find_regions(frontier) if len(region) >= MIN_REGION]
    goals = [CENTRES[cell] for region in regions for cell in region]
    for goal in sorted(goals, key=lambda goal: (math.dist(start, goal), goal)):
        if straight_way(start, goal, free, walls):
            return goal
    return None


def keep_mapping(seconds):
    for tick in range(round(seconds * 10)):
        (x, y), facing = where(), heading()
        for angle, reading in scan():
            add_beam(x, y, facing + angle, reading)
        if tick % 5 == 0:
            show()
        wait(0.1)
    stop()
    show()


def where():
    return START[0] + position()[0], START[1] + position()[1]


def show():
    free, occupied, frontier = read_map()
    draw("free", [CENTRES[cell] for cell in sorted(free)], "#9ecae1", "squares", CELL)
    draw("occupied", [CENTRES[cell] for cell in sorted(occupied)], "black", "squares", CELL)
    draw("frontier", [CENTRES[cell] for cell in sorted(frontier)], "gold", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
    plot("frontier cells", len(frontier))


right(30)
keep_mapping(10)
x, y = where()
goal = choose_goal((x, y))
if goal is None:
    print("No frontier worth it can be reached in a straight line.")
else:
    draw("goal", [goal], "red", "dots", 5)
    bearing = math.degrees(math.atan2(goal[0] - x, goal[1] - y))
    turn((bearing - heading() + 180) % 360 - 180)  # the shorter way round
    forward(100)  # 11.5 cm a second
    keep_mapping(math.dist((x, y), goal) / 11.5)
    right(30)
    keep_mapping(8)
