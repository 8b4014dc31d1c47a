# earns: the heading that comes back is the guess's
# The best pose near the guess
#
# The robot turns once and makes a map. Then it looks
# again, but believes itself to be a little beside its
# place, and turned: the red dots. Find the pose at which
# they fit the map best: the green dots should lie on it.

from bugbot import *
import math

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp
KNOWN = 1  # beyond this, either way, a cell is known

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]
START = (72, 100)  # where it starts; odometry() counts from there

TURNS = [0, -1, 1, -2, 2, -3, 3]  # headings to try, from the guess [degrees]
SHIFTS = [0, -2, 2]  # and places, along x and along y [cm]


# ---- your part ----
def fit(field, x, y, facing, hits):
    """How well hits agree with a field, seen from this pose, 0 to 1.

    field: for each cell how well a hit there agrees with the map
    hits: pairs (cm ahead of the robot, cm to its right)
    """
    total = 0
    for px, py in on_mat(x, y, facing, hits):
        column, row = math.floor(px / CELL), math.floor(py / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            total += field[row * ACROSS + column]
    return total / len(hits)


def match(field, x, y, facing, hits):
    """The pose near (x, y, facing) at which the hits fit best."""
    best, best_fit = (x, y, facing), fit(field, x, y, facing, hits)
    for turned in TURNS:
        for dx in SHIFTS:
            for dy in SHIFTS:
                pose = x + dx, y + dy, facing + turned
                found = fit(field, *pose, hits)
                if found > best_fit:
                    best, best_fit = (x + dx, y + dy, facing), found
    return best


# ---- end of your part ----


# The rest is for you to read and use.
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


def field_of(log_odds):
    """How well a hit in each cell would agree with the map."""
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


def on_mat(x, y, facing, points):
    """Hits, (ahead, right) of a pose, as points on the mat."""
    dx, dy = math.sin(math.radians(facing)), math.cos(math.radians(facing))
    return [(x + a * dx + r * dy, y + a * dy - r * dx) for a, r in points]


log_odds = [0.0] * (ACROSS * ACROSS)
hits = []
right(50)  # 60 degrees a second
for tick in range(80):  # 8 seconds
    for angle, reading in scan():
        if tick < 60:  # once round for the map
            add_beam(log_odds, *START, heading() + angle, reading)
        elif reading < FAR:  # a third of a turn to be matched
            way = math.radians(heading() + angle)
            x, y = reading * math.sin(way), reading * math.cos(way)
            hits.append((y, x))  # as a robot that faces up sees it
    wait(0.1)
stop()
black = [centre(cell) for cell in range(len(log_odds)) if log_odds[cell] > KNOWN]
draw("occupied", black, "black", "squares", CELL)

guess = START[0] + 2, START[1] - 2, 3
field = field_of(log_odds)
best = match(field, *guess, hits)
draw("as guessed", on_mat(*guess, hits), "red", "dots", 1.5)
draw("as matched", on_mat(*best, hits), "green", "dots", 1.5)
print(f"guess: {guess}, fit {fit(field, *guess, hits):.2f}")
print(f"match: {best}, fit {fit(field, *best, hits):.2f}")
