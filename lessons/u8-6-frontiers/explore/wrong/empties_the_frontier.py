# earns: has to stay as it was
# Explore
#
# The robot maps, finds where free floor meets the
# unknown, plans a way there, drives it with its eyes
# open, and does so again until nothing is left to do.
# Then it says why it stops.

from bugbot import *
from heapq import heappop, heappush
from math import atan2, cos, degrees, dist, floor, hypot, inf, radians, sin

MIN_REGION = 5  # frontier regions of fewer cells are left out
SPARE = 7  # cm from the robot's middle to anything not free
NEAR = 12  # cm: so near to a frontier is near enough to look
GAIN = 1  # cells of way that a cell of frontier is worth
MAX_TIME = 240  # s: the robot gives up then

CELL, ACROSS, FAR = 5, 40, 170
START = (100, 25)  # where it starts; position() counts from there
L_OCC, L_FREE, L_MAX, KNOWN = 0.85, -0.4, 8, 0.62  # 0.62 is p = 0.65
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
CORNERS = [(-1, -1), (1, -1), (-1, 1), (1, 1)]


# ---- your part ----
def choose_goal(here, frontier, room, tried):
    """Where to look at the unknown from: returns (goal, why).

    here: the robot's cell. frontier, room: sets of cells.
    tried: frontier cells that were looked at from close by
    in vain. Leave them out. goal: a cell, or None if there
    is none. why: None, or the reason why there is none.
    """
    if not frontier:
        return None, "no frontier is left"
    frontier -= tried
    regions = [region for region in find_regions(frontier) if len(region) >= MIN_REGION]
    if not regions:
        return None, "only small frontiers are left"
    reached, best, most = flood(here, room, SIDES), None, -inf
    for region in regions:
        spots = [cell for cell in reached if near(cell, region)]
        if spots:
            middle = [sum(each) / len(region) for each in zip(*region)]
            goal = min(spots, key=lambda cell: (dist(cell, middle), cell))
            worth = GAIN * len(region) - len(find_way(here, goal, room))
            if worth > most:
                best, most = goal, worth
    return (best, None) if best else (None, "no frontier can be reached")


def explore():
    """Look round, go to goals until there is none; returns why it stops."""
    tried, goal = set(), None
    look_round()
    while clock() < MAX_TIME:
        free, occupied, frontier = read_map()
        edge = find_edge(free)
        room = find_room(free, edge)
        here = own_cell(free, room)
        if here is None:
            return "the robot has no room"
        way = find_way(here, goal, room) if goal and near(goal, frontier - tried) else []
        if not way:  # no goal yet, or nothing is left to see there, or the way is closed
            goal, why = choose_goal(here, frontier, room, tried)
            if why:
                return why
            draw("goal", [centre(goal)], "red", "dots", 5)
        elif dist(where(), centre(goal)) > 3:
            drive_along(way, edge)
        else:
            look_round()
            tried |= {cell for cell in read_map()[2] if near(cell, [goal])}
    return "time is up"


# ---- end of your part ----


# The mapper of U8.4, with its cells in a dictionary.
log_odds = {(column, row): 0.0 for row in range(ACROSS) for column in range(ACROSS)}
bumps = set()  # cells that stopped the robot, whatever the map says


def cell_of(x, y):
    return floor(x / CELL), floor(y / CELL)


def centre(cell):
    return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL


def where():
    return START[0] + position()[0], START[1] + position()[1]


def look():
    """Add one scan to the map."""
    (x, y), facing = where(), heading()
    for angle, reading in scan():
        dx, dy = sin(radians(facing + angle)), cos(radians(facing + angle))
        clear = reading - CELL if reading < FAR else FAR
        evidence = [(i * CELL / 2, L_FREE) for i in range(int(clear / (CELL / 2)))]
        if reading < FAR:
            evidence.append((reading, L_OCC))
        for along, weight in evidence:
            cell = cell_of(x + along * dx, y + along * dy)
            if cell in log_odds:
                log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def beside(cell, steps):
    return {(cell[0] + column, cell[1] + row) for column, row in steps}


BESIDE = {cell: beside(cell, SIDES) for cell in log_odds}


# The map, its frontier and its regions.
def read_map():
    """The map as sets of cells: free, occupied, and the frontier."""
    free = {cell for cell, l in log_odds.items() if l < -KNOWN}
    occupied = {cell for cell, l in log_odds.items() if l > KNOWN}
    unknown = log_odds.keys() - free - occupied
    return (
        free,
        occupied,
        {cell for cell in free if not BESIDE[cell].isdisjoint(unknown)},
    )


def flood(cell, cells, steps):
    """All of the cells that hang together with this one, the nearest first."""
    region, left = [cell], cells - {cell}
    for each in region:  # the list grows while we walk along it
        new = beside(each, steps) & left
        region.extend(new)
        left -= new
    return region


def find_regions(frontier):
    """Groups of cells that hang together by sides or corners."""
    left, regions = set(frontier), []
    while left:
        regions.append(flood(min(left), left, SIDES + CORNERS))
        left -= set(regions[-1])
    return regions


def near(cell, cells):
    """Is one of the cells within NEAR of this cell?"""
    return any(dist(cell, each) * CELL < NEAR for each in cells)


# Ways.
FROM_EDGE = SPARE + CELL / 2  # cm to the middle of a cell of the edge, at least
REACH = range(-int(FROM_EDGE / CELL) - 1, int(FROM_EDGE / CELL) + 2)
AROUND = [(column, row) for column in REACH for row in REACH]  # steps to all cells so near


def find_edge(free):
    """What is beside free floor and not free: walls, unknown, the mat's end, bumps."""
    return set().union(*(BESIDE[cell] for cell in free)) - free | bumps


def find_room(free, edge):
    """The free cells on whose middle the robot keeps SPARE from the edge."""
    close = [step for step in AROUND if hypot(*step) * CELL < FROM_EDGE]
    return free - set().union(*(beside(cell, close) for cell in edge))


def own_cell(free, room):
    """The robot's cell, or the nearest one with room that hangs together with it."""
    here = cell_of(*where())
    if here in room:
        return here
    return next((cell for cell in flood(here, free, SIDES) if cell in room), None)


def find_way(start, goal, room):
    """A*: the shortest way through cells with room, a list of cells; [] if there is none."""
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
            so_far = length[cell] + hypot(column, row)
            if so_far < length.get(new, inf):
                length[new], before[new] = so_far, cell
                heappush(waiting, (so_far + dist(new, goal), new))
    return []


def straight_way(start, goal, edge):
    """Has the line from start to goal SPARE on both sides?"""
    steps = int(dist(start, goal) / CELL) + 1
    for i in range(1, steps + 1):
        point = [a + (b - a) * i / steps for a, b in zip(start, goal)]
        close = beside(cell_of(*point), AROUND) & edge
        if any(dist(point, centre(cell)) < FROM_EDGE for cell in close):
            return False
    return True


# Driving.
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


def drive_along(way, edge):
    """Drive up to 0.8 s towards the farthest cell of the way that is straight ahead."""
    target = next((cell for cell in way[::-1] if straight_way(where(), centre(cell), edge)), None)
    if target is None:
        target = way[0] if dist(where(), centre(way[0])) > CELL else way[:2][-1]
    for i in range(8):
        step_to(centre(target))
        if dist(where(), centre(target)) < 1.5:
            break
    stop()


def step_to(point):
    """Turn towards a point, or go there if the robot faces it."""
    (x, y), (goal_x, goal_y) = where(), point
    off = (degrees(atan2(goal_x - x, goal_y - y)) - heading() + 180) % 360 - 180
    tick(5 * off, 100 if abs(off) < 15 else 0)
    if abs(off) < 15 and where() == (
        x,
        y,
    ):  # something is there that the map doesn't show
        ahead = radians(heading())
        bumps.add(cell_of(x + 7 * sin(ahead), y + 7 * cos(ahead)))
        backward(50, distance=CELL)


def show():
    free, occupied, frontier = read_map()
    draw("free", [centre(cell) for cell in sorted(free)], "#9ecae1", "squares", CELL)
    draw(
        "occupied",
        [centre(cell) for cell in sorted(occupied)],
        "black",
        "squares",
        CELL,
    )
    draw("frontier", [centre(cell) for cell in sorted(frontier)], "gold", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
    plot("frontier cells", len(frontier))


why = explore()
stop()
show()
print("The robot stops:", why + ".")
