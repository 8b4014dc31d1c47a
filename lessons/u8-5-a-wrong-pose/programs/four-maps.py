# Four maps of one run
#
# The robot drives four times round its ring. One and the
# same run gives four maps: from the poses of odometry as
# they are, with one drift taken out, mended by scan
# matching on the way, and from those of the camera.

from bugbot import *
import math

# Numbers to change
SHOW = 2  # which map to draw: 0 odometry, 1 one drift, 2 matched, 3 camera (0 to 3)
GATHER = 5  # looks that are matched as one (1 to 10)
LAG = 10  # they are matched with the map of so many seconds ago (0 to 20)
BELIEVE = 0.5  # how much of what a match finds is believed (0 to 1)

TURNS = [0, -1, 1, -2, 2, -3, 3]  # headings to try, from the guess
SHIFTS = [0, -2, 2]  # and places, along x and along y
L_OCC, L_FREE, L_MAX, KNOWN = 0.85, -0.4, 8, 1
CELL, ACROSS, FAR, START = 5, 40, 170, (72, 100)
# What really stands in the hall: left, bottom, width, height. The
# maps never look at this; it is here to count their mistakes.
REAL = [
    (88, 94, 12, 12),
    (130, 150, 50, 8),
    (20, 145, 30, 30),
    (150, 35, 8, 45),
    (40, 25, 50, 8),
]


def add_beam(log_odds, x, y, angle, reading):
    """Add what one beam from (x, y) says to the flat list."""
    dx = math.sin(math.radians(angle))
    dy = math.cos(math.radians(angle))
    step = CELL / 2
    clear = reading - CELL if reading < FAR else FAR
    evidence = [(i * step, L_FREE) for i in range(int(clear / step))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        column = math.floor((x + along * dx) / CELL)
        row = math.floor((y + along * dy) / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            cell = row * ACROSS + column
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


def gap(x, y):
    """Distance to the nearest thing really there [cm]."""
    nearest = min(x, 200 - x, y, 200 - y)
    for left, bottom, width, height in REAL:
        dx = max(left - x, 0, x - (left + width))
        dy = max(bottom - y, 0, y - (bottom + height))
        nearest = min(nearest, math.hypot(dx, dy))
    return nearest


def step_of(before, now):
    """The way from one pose to another: (ahead, right) of the first."""
    way = math.radians(before[2])
    dx, dy = now[0] - before[0], now[1] - before[1]
    return (
        dx * math.sin(way) + dy * math.cos(way),
        dx * math.cos(way) - dy * math.sin(way),
    )


def after(pose, step, turned=0):
    """The pose after a step (ahead, right) and a turn."""
    way = math.radians(pose[2])
    x = pose[0] + step[0] * math.sin(way) + step[1] * math.cos(way)
    y = pose[1] + step[0] * math.cos(way) - step[1] * math.sin(way)
    return x, y, pose[2] + turned


def corrected(looks, rate):
    """The poses of the looks on the mat, with one drift taken out."""
    x, y, poses = *START, []
    before = looks[0][1]
    for t, now, readings in looks:
        back = math.radians(rate * t)
        dx, dy = now[0] - before[0], now[1] - before[1]
        x += dx * math.cos(back) - dy * math.sin(back)
        y += dy * math.cos(back) + dx * math.sin(back)
        poses.append((x, y, now[2] - rate * t))
        before = now
    return poses


def ends(pose, readings):
    """Where the beams of a look ended on the mat."""
    hits = [(angle, reading) for angle, reading in readings if reading < FAR]
    return [after((*pose[:2], pose[2] + a), (reading, 0))[:2] for a, reading in hits]


def find_rate(looks):
    """The drift that makes the sharpest map."""

    def cells(rate):
        poses = corrected(looks, rate)
        points = [p for pose, look in zip(poses, looks) for p in ends(pose, look[2])]
        return len({(x // CELL, y // CELL) for x, y in points})

    return min([i * 0.02 for i in range(-20, 21)], key=cells)


def field_of(log_odds):
    """How well a hit in each cell would agree with the map, 0 to 1."""
    own = [min(max(each, 0), 3) / 3 for each in log_odds]
    field = own[:]
    for cell, each in enumerate(own):
        if each > 0:  # a hit beside a wall is half right
            column, row = cell % ACROSS, cell // ACROSS
            for c, r in ((-1, 0), (1, 0), (0, -1), (0, 1)):
                if 0 <= column + c < ACROSS and 0 <= row + r < ACROSS:
                    beside = (row + r) * ACROSS + column + c
                    field[beside] = max(field[beside], each / 2)
    return field


def fit(field, pose, hits):
    """How well hits agree with a field, seen from this pose, 0 to 1."""
    total = 0
    for hit in hits:
        x, y, _ = after(pose, hit)
        column, row = math.floor(x / CELL), math.floor(y / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            total += field[row * ACROSS + column]
    return total / len(hits)


def match(field, guess, hits):
    """The pose near the guess at which the hits fit best, and how well."""
    best, most = guess, fit(field, guess, hits)
    for turned in TURNS:
        for dx in SHIFTS:
            for dy in SHIFTS:
                pose = guess[0] + dx, guess[1] + dy, guess[2] + turned
                found = fit(field, pose, hits)
                if found > most:
                    best, most = pose, found
    return best, most


def follow(looks):
    """The poses of the looks, mended by matching on the way."""
    old, poses, added = [0.0] * (ACROSS * ACROSS), [], 0
    pose, believed = (*START, looks[0][1][2]), looks[0][1]
    for number, (t, now, readings) in enumerate(looks):
        pose = after(pose, step_of(believed, now), now[2] - believed[2])
        believed = now
        poses.append(pose)
        if number % GATHER < GATHER - 1:
            continue
        first = number - GATHER + 1
        while added < first and looks[added][0] <= t - LAG:
            add_look(old, poses[added], looks[added][2])
            added += 1
        batch = range(first, number + 1)
        points = [p for i in batch for p in ends(poses[i], looks[i][2])]
        hits = [step_of(pose, point) for point in points]
        if not hits:
            continue
        best, how_well = match(field_of(old), pose, hits)
        if how_well > 0.3:  # else this was not on the map yet
            mended = tuple(a + BELIEVE * (b - a) for a, b in zip(pose, best))
            for i in batch:  # they all move together
                turned = poses[i][2] - pose[2]
                poses[i] = after(mended, step_of(pose, poses[i]), turned)
            pose = mended
    return poses


def add_look(log_odds, pose, readings):
    """Add one look to a map."""
    for angle, reading in readings:
        add_beam(log_odds, pose[0], pose[1], pose[2] + angle, reading)


def map_of(poses, looks):
    """The map of the looks from these poses: its free and its occupied cells."""
    log_odds = [0.0] * (ACROSS * ACROSS)
    for pose, look in zip(poses, looks):
        add_look(log_odds, pose, look[2])
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    return free, [centre(cell) for cell in cells if log_odds[cell] > KNOWN]


looks, camera = [], []
drive(100, 0, 25)
for tick in range(240):  # 48 seconds
    looks.append((clock(), odometry(), scan()))
    camera.append((START[0] + position()[0], START[1] + position()[1], heading()))
    wait(0.2)
stop()

maps = {
    "odometry": corrected(looks, 0),
    "one drift": corrected(looks, find_rate(looks)),
    "matched": follow(looks),
    "camera": camera,
}
for number, (name, poses) in enumerate(maps.items()):
    free, occupied = map_of(poses, looks)
    wrong = [point for point in occupied if gap(*point) > CELL]
    print(f"{name}: {100 * len(wrong) / max(1, len(occupied)):.1f} % wrong")
    if number == SHOW:
        draw("free", free, "#9ecae1", "squares", CELL)
        draw("occupied", occupied, "black", "squares", CELL)
        draw("wrong", wrong, "red", "dots", 3)
        draw("way", [pose[:2] for pose in poses], "green", "line", 1)
