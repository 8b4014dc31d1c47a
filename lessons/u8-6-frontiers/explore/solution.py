# Explore
#
# The robot maps, finds where free floor meets the unknown,
# plans a way there, drives it with its eyes open, and does
# so again until nothing is left to do. At the end it says
# why it stops.

from bugbot import *
from heapq import heappop, heappush
from math import atan2, cos, degrees, dist, floor, hypot, inf, radians, sin

MIN_REGION = 5  # frontier regions of fewer cells are left out
SPARE = 7  # cm from the robot's middle to anything not free
NEAR = 12  # cm: this near to a frontier is near enough
GAIN = 1  # cells of way that a cell of frontier is worth
MAX_TIME = 240  # s: the robot gives up then

CELL, ACROSS, FAR = 5, 40, 170
START = (100, 25)  # where it starts; position() counts from there
L_OCC, L_FREE, L_MAX, KNOWN = 0.85, -0.4, 8, 0.62  # 0.62 is p = 0.65
log_odds = {(column, row): 0.0 for row in range(ACROSS) for column in range(ACROSS)}
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
CORNERS = [(-1, -1), (1, -1), (-1, 1), (1, 1)]


# ---- the mapper of U8.4 ----
def cell_of(x, y):
    return floor(x / CELL), floor(y / CELL)


def centre(cell):
    return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL


def where():
    return START[0] + position()[0], START[1] + position()[1]


def look():
    """Add one scan to the map."""
    (x, y), facing, readings = where(), heading(), scan()
    for angle, reading in readings:
        dx, dy = sin(radians(facing + angle)), cos(radians(facing + angle))
        clear = reading - CELL if reading < FAR else FAR
        evidence = [(i * CELL / 2, L_FREE) for i in range(int(clear / (CELL / 2)))]
        if reading < FAR:
            evidence.append((reading, L_OCC))
        for along, weight in evidence:
            cell = cell_of(x + along * dx, y + along * dy)
            if cell in log_odds:
                log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


# ---- frontiers ----
def beside(cell, steps):
    return {(cell[0] + column, cell[1] + row) for column, row in steps}


def read_map():
    """The map as sets of cells: free, occupied, and the frontier."""
    free = {cell for cell, l in log_odds.items() if l < -KNOWN}
    occupied = {cell for cell, l in log_odds.items() if l > KNOWN}
    unknown = log_odds.keys() - free - occupied
    return free, occupied, {cell for cell in free if beside(cell, SIDES) & unknown}


def flood(cell, cells, steps):
    """All of the cells that hang together with this one, by these steps."""
    region, left = [cell], cells - {cell}
    for each in region:  # the list grows while we walk along it
        new = beside(each, steps) & left
        region.extend(new)
        left -= new
    return region  # the nearest first


def find_regions(frontier):
    left, regions = set(frontier), []
    while left:
        regions.append(flood(min(left), left, SIDES + CORNERS))
        left -= set(regions[-1])
    return regions


# ---- ways ----
def find_edge(free):
    """What is beside free floor without being free: walls, unknown, the end of the mat."""
    return set().union(*(beside(cell, SIDES) for cell in free)) - free


def find_room(free, edge):
    """The free cells on whose middle the robot can stand with SPARE all round."""
    far = SPARE + CELL / 2
    reach = range(-int(far / CELL), int(far / CELL) + 1)
    near = [(column, row) for column in reach for row in reach if hypot(column, row) * CELL < far]
    return free - set().union(*(beside(cell, near) for cell in edge))


def find_way(start, goal, room):
    """A*: the shortest way through cells with room, as a list of cells; [] if there is none."""
    length, before, waiting = {start: 0}, {start: None}, [(0, start)]
    while waiting:
        cell = heappop(waiting)[1]
        if cell == goal:
            way = []
            while cell:
                way.append(cell)
                cell = before[cell]
            return way[::-1]
        for column, row in SIDES + CORNERS:
            new = cell[0] + column, cell[1] + row
            if not {new, (new[0], cell[1]), (cell[0], new[1])} <= room:
                continue  # no room, or not round this corner
            so_far = length[cell] + hypot(column, row) * CELL
            if so_far < length.get(new, inf):
                length[new], before[new] = so_far, cell
                heappush(waiting, (so_far + dist(centre(new), centre(goal)), new))
    return []


def straight_way(start, goal, edge):
    """Has the line from start to goal SPARE on both sides?"""
    middles = [centre(cell) for cell in edge]
    steps = int(dist(start, goal) / CELL) + 1
    for i in range(1, steps + 1):
        point = [a + (b - a) * i / steps for a, b in zip(start, goal)]
        if min(dist(point, middle) for middle in middles) < SPARE + CELL / 2:
            return False
    return True


# ---- where to ----
def choose_goal(here, frontier, room):
    """The best cell to look at the unknown from, and None; or None, and why there is none."""
    regions = [region for region in find_regions(frontier - tried) if len(region) >= MIN_REGION]
    if not frontier:
        return None, "no frontier is left"
    if not regions:
        return None, "only small frontiers are left"
    reached, best = flood(here, room, SIDES), {}
    for region in regions:
        middle = [sum(each) / len(region) for each in zip(*region)]
        spots = [cell for cell in reached if near(cell, region)]
        if spots:
            goal = min(spots, key=lambda cell: (dist(cell, middle), cell))
            way = len(find_way(here, goal, room))
            best[GAIN * len(region) - way, goal] = goal
    if not best:
        return None, "no frontier can be reached"
    return best[max(best)], None


def near(cell, cells):
    return any(dist(cell, each) * CELL < NEAR for each in cells)


# ---- driving ----
def tick(turning, forwards=0):
    """Drive for a tenth of a second, and look."""
    drive(forwards, 0, turning)
    wait(0.1)
    look()
    if round(clock() * 10) % 5 == 0:
        show()


def look_round():
    for i in range(50):
        tick(60)


def step_to(point):
    """Turn towards a point, or go there if the robot faces it."""
    (x, y), (goal_x, goal_y) = where(), point
    off = (degrees(atan2(goal_x - x, goal_y - y)) - heading() + 180) % 360 - 180
    if abs(off) > 15:
        tick(5 * off)
        return
    tick(5 * off, 100)
    if dist(where(), (x, y)) < 0.1:  # it touches something that is not on the map
        way = radians(heading())
        bumps.add(cell_of(x + 7 * sin(way), y + 7 * cos(way)))
        backward(50, distance=CELL)


def show():
    free, occupied, frontier = read_map()
    draw("free", [centre(cell) for cell in sorted(free)], "#9ecae1", "squares", CELL)
    draw("occupied", [centre(cell) for cell in sorted(occupied)], "black", "squares", CELL)
    draw("frontier", [centre(cell) for cell in sorted(frontier)], "gold", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
    plot("frontier cells", len(frontier))


tried, bumps, goal, why = set(), set(), None, None
look_round()
while not why:
    free, occupied, frontier = read_map()
    edge = find_edge(free) | bumps
    room = find_room(free, edge)
    here = next((cell for cell in flood(cell_of(*where()), free, SIDES) if cell in room), None)
    way = find_way(here, goal, room) if here and goal and near(goal, frontier - tried) else []
    if clock() > MAX_TIME:
        why = "time is up"
    elif here is None:
        why = "it has no room to move"
    elif not way:
        goal, why = choose_goal(here, frontier, room)
        draw("goal", [centre(goal)] if goal else [], "red", "dots", 5)
    elif dist(where(), centre(goal)) < 3:
        look_round()
        tried |= {cell for cell in read_map()[2] if near(cell, [goal])}
    else:
        straight = [cell for cell in way if straight_way(where(), centre(cell), edge)]
        next_cell = here if dist(where(), centre(here)) > CELL else way[1]
        target = centre(straight[-1] if straight else next_cell)
        for i in range(8):
            step_to(target)
            if dist(where(), target) < 1.5:
                break
        drive(0, 0, 0)
stop()
show()
print("The robot stops:", why + ".")
