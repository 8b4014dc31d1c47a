# style: a wave from the robot to the nearest frontier, a list of lists, each crossed cell once
from bugbot import *
from collections import deque
from math import atan2, ceil, cos, degrees, floor, hypot, inf, radians, sin

CELL, N, FAR = 5, 40, 170
START_X, START_Y = 100, 25
SPIN = 60
grid = [[0.0] * N for _ in range(N)]  # grid[row][column], log odds
given_up = set()
driven = 0.0


def here():
    x, y = position()
    return START_X + x, START_Y + y


def inside(c, r):
    return 0 <= c < N and 0 <= r < N


def add(c, r, weight):
    if inside(c, r):
        grid[r][c] = max(-8, min(8, grid[r][c] + weight))


def walk(x, y, dx, dy, length):
    """Each cell that a beam crosses, once."""
    c, r = floor(x / CELL), floor(y / CELL)
    to_x = ((c + (dx > 0)) * CELL - x) / dx if dx else inf
    to_y = ((r + (dy > 0)) * CELL - y) / dy if dy else inf
    while True:
        yield c, r
        if min(to_x, to_y) >= length:
            return
        if to_x < to_y:
            to_x += CELL / abs(dx)
            c += 1 if dx > 0 else -1
        else:
            to_y += CELL / abs(dy)
            r += 1 if dy > 0 else -1


def look():
    (x, y), facing = here(), heading()
    for angle, reading in scan():
        way = radians(facing + angle)
        dx, dy = sin(way), cos(way)
        for c, r in walk(x, y, dx, dy, max(0.1, reading - CELL) if reading < FAR else FAR):
            add(c, r, -0.5)
        if reading < FAR:
            add(floor((x + reading * dx) / CELL), floor((y + reading * dy) / CELL), 0.85)


def state(c, r):
    return "#" if grid[r][c] > 0.62 else "." if grid[r][c] < -0.62 else "?"


def read_map():
    states = [[state(c, r) for c in range(N)] for r in range(N)]
    edge = {
        (c, r)
        for r in range(N)
        for c in range(N)
        if states[r][c] == "." and any(inside(a, b) and states[b][a] == "?" for a, b in sides(c, r))
    }
    return states, edge


def sides(c, r):
    return (c + 1, r), (c - 1, r), (c, r + 1), (c, r - 1)


def eight(c, r):
    return [(a, b) for a in (c - 1, c, c + 1) for b in (r - 1, r, r + 1) if (a, b) != (c, r)]


def worth_it(edge):
    """The frontier cells that have not been given up, in groups of five and more."""
    left, good = edge - given_up, set()
    while left:
        group, todo = set(), [left.pop()]
        while todo:
            cell = todo.pop()
            group.add(cell)
            near = left.intersection(eight(*cell))
            left -= near
            todo.extend(near)
        if len(group) > 4:
            good |= group
    return good


def safe_cells(states, spare):
    """The free cells that are at least so many cm from all walls."""
    steps = ceil((spare + 2.5) / CELL)
    disc = [
        (a, b)
        for a in range(-steps, steps + 1)
        for b in range(-steps, steps + 1)
        if hypot(a, b) * CELL < spare + 2.5
    ]
    walls = [(c, r) for r in range(N) for c in range(N) if states[r][c] == "#"]
    walls += [(c, r) for c in range(-1, N + 1) for r in (-1, N)]
    walls += [(c, r) for r in range(N) for c in (-1, N)]
    close = {(c + a, r + b) for c, r in walls for a, b in disc}
    return {(c, r) for r in range(N) for c in range(N) if states[r][c] == "."} - close


def wave(start, safe, wide, targets):
    """A wave over safe cells; the way to the first that is close to a target, or None."""
    before, cost, ring = {start: None}, {start: 0}, [[start]]
    far = 0
    while far < len(ring):
        for cell in ring[far]:
            if cost[cell] != far:
                continue
            if any((cell[0] + a, cell[1] + b) in targets for a, b in CLOSE):
                way = []
                while cell:
                    way.append(cell)
                    cell = before[cell]
                return way[::-1]
            c, r = cell
            for new in eight(c, r):
                if new not in safe or (new[0], r) not in safe or (c, new[1]) not in safe:
                    continue
                step = (2 if new[0] == c or new[1] == r else 3) * (1 if new in wide else 3)
                if far + step < cost.get(new, inf):
                    cost[new], before[new] = far + step, cell
                    while len(ring) <= far + step:
                        ring.append([])
                    ring[far + step].append(new)
        far += 1
    return None


CLOSE = [(a, b) for a in range(-2, 3) for b in range(-2, 3) if hypot(a, b) < 2.4]


def middle(cell):
    return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL


def drive_to(x, y):
    """For a tenth of a second, turning; returns how far it came."""
    global driven
    px, py = here()
    off = atan2(x - px, y - py) - radians(heading() + 0.06 * SPIN)
    speed = min(100, 87 * hypot(x - px, y - py))
    drive(speed * cos(off), speed * sin(off), SPIN)
    wait(0.1)
    look()
    nx, ny = here()
    driven += hypot(nx - px, ny - py)
    return hypot(nx - px, ny - py) / max(0.01, 0.0115 * speed)


def straight(a, b, wide):
    steps = int(hypot(b[0] - a[0], b[1] - a[1]) / 2) + 1
    points = [
        (a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps)
        for i in range(steps + 1)
    ]
    return all((floor(x / CELL), floor(y / CELL)) in wide for x, y in points)


def show():
    states, edge = read_map()
    layers = {".": [], "#": [], "?": []}
    for r in range(N):
        for c in range(N):
            layers[states[r][c]].append(middle((c, r)))
    draw("free", layers["."], "#9ecae1", "squares", CELL)
    draw("occupied", layers["#"], "black", "squares", CELL)
    draw("frontier", [middle(cell) for cell in sorted(edge)], "gold", "squares", CELL)


def turn_round(cells=()):
    """Once round, or until each of the cells has been looked at for a while."""
    x, y = here()
    looks = dict.fromkeys(cells, 0)
    for _ in range(50):
        drive_to(x, y)
        for cell in looks:
            to_x, to_y = middle(cell)
            off = degrees(atan2(to_x - x, to_y - y)) - heading()
            looks[cell] += abs((off + 180) % 360 - 180) < 20
        if looks and min(looks.values()) > 3:
            return


def explore():
    turn_round()
    while clock() < 200 and driven < 1600:
        states, edge = read_map()
        if not edge:
            return "no frontier is left"
        targets = worth_it(edge)
        if not targets:
            return "only small frontiers are left"
        safe = safe_cells(states, 6)
        wide = safe_cells(states, 11) & safe
        x, y = here()
        start = min(safe, key=lambda cell: hypot(middle(cell)[0] - x, middle(cell)[1] - y))
        way = wave(start, safe, wide, targets)
        if way is None:
            return "no frontier can be reached"
        if len(way) == 1 and hypot(middle(start)[0] - x, middle(start)[1] - y) < 1.5:
            seen = {(start[0] + a, start[1] + b) for a, b in CLOSE} & targets
            turn_round(seen)
            given_up.update(seen & read_map()[1])
            continue
        goal = middle(way[min(1, len(way) - 1)])
        for cell in reversed(way[2:]):
            if straight((x, y), middle(cell), wide):
                goal = middle(cell)
                break
        if hypot(middle(start)[0] - x, middle(start)[1] - y) > 4:
            goal = middle(start)
        for _ in range(5):
            if drive_to(*goal) < 0.3:  # something is in the way that the map does not show
                x, y = here()
                way_there = atan2(goal[0] - x, goal[1] - y)
                for side in (-0.5, 0, 0.5):
                    c = floor((x + 6.5 * sin(way_there + side)) / CELL)
                    r = floor((y + 6.5 * cos(way_there + side)) / CELL)
                    add(c, r, 16)
                for _ in range(3):
                    drive_to(x - 20 * sin(way_there), y - 20 * cos(way_there))
                break
            if hypot(goal[0] - here()[0], goal[1] - here()[1]) < 1:
                break
    return "time is up" if clock() >= 200 else "it has driven far enough"


why = explore()
stop()
show()
print(f"The robot stops: {why}.")
