"""fit() and match() on small fields, and on one made from a map."""

from math import floor

from grader import calls, check, function, lacks, mistake, near, reads
from mapping.grid import Grid
from mapping.mapper import Mapper
from mapping.matching import Window, hits_of, likelihoods, place
from mapping.matching import match as best_match
from mapping.score import gap_cm

TURNS = [0, -1, 1, -2, 2, -3, 3]
SHIFTS = [0, -2, 2]
WINDOW = Window(3, 1, 2, 2, turn_cost=0, shift_cost=0)


def cell_value(field, x, y):
    column, row = floor(x / 5), floor(y / 5)
    return field[row * 40 + column] if 0 <= column < 40 and 0 <= row < 40 else 0


def truncated(field, x, y):
    column, row = int(x / 5), int(y / 5)
    return field[row * 40 + column] if 0 <= column < 40 and 0 <= row < 40 else 0


def fit_by(value=cell_value, seen=place, mean=True, of=lambda points: len(points)):
    """How well hits agree with a field, or a slip of it."""

    def fit(field, x, y, facing, hits):
        points = [seen((x, y, facing), hit) for hit in hits]
        total = sum(value(field, *point) for point in points)
        return total / of(points) if mean else total

    return fit


def on_the_mat(points):
    """How many of the points are on the mat, at least 1."""
    return max(1, sum(0 <= x < 200 and 0 <= y < 200 for x, y in points))


fit = function(
    "fit(field, x, y, facing, hits)",
    fit_by(),
    compare=near(0.0001),
    leaves=True,
    mistakes=[
        ("the mean is wanted: divide the sum by the number of hits", fit_by(mean=False), 0),
        (
            "row and column look swapped: cell number row * ACROSS + column",
            fit_by(lambda field, x, y: cell_value(field, y, x)),
            0,
        ),
        (
            "hits are (ahead, right) of the robot: on_mat() says where on the mat they are",
            fit_by(seen=lambda pose, hit: (pose[0] + hit[0], pose[1] + hit[1])),
            0,
        ),
        (
            "a hit beyond the mat is in no cell, and adds nothing",
            fit_by(lambda field, x, y: field[(floor(y / 5) * 40 + floor(x / 5)) % 1600]),
            0,
        ),
        (
            "the mean is of all hits: those beyond the mat add 0, and count all the same",
            fit_by(of=on_the_mat),
            0,
        ),
        mistake(
            "int() rounds -0.4 to 0, so a hit just off the mat gets a cell: use math.floor()",
            fit_by(truncated),
            0,
            where=calls("int"),
        ),
    ],
)


def scene():
    """A map's field, and what a robot at TRUE sees: the edges of the mat and two boxes."""
    mapper = Mapper()
    for facing in range(0, 360, 3):
        mapper.add_scan(100, 100, facing, [(0, min(150.0, reach(100, 100, facing)))])
    looks = [(a, reach(*TRUE[:2], TRUE[2] + a)) for a in range(-60, 61, 4)]
    return likelihoods(mapper.grid).cells, [list(hit) for hit in hits_of(looks)]


def reach(x, y, facing):
    """How far one sees in that direction [cm], in steps of half a centimetre."""
    for half in range(1, 400):
        if (
            gap_cm(*place((x, y, facing), (half / 2, 0)), [(120, 140, 40, 10), (40, 60, 10, 40)])
            <= 0
        ):
            return half / 2
    return 200.0


TRUE = (104.0, 97.0, 20.0)
FIELD, HITS = scene()


def fits_as_well(field, hits):
    """Any pose that fits as well as the best one of the window will do."""

    def as_well(wanted, got):
        try:
            x, y, facing = got
            found = fit_by()(field, x, y, facing, hits)
            return abs(found - fit_by()(field, *wanted, hits)) < 1e-6
        except (TypeError, ValueError):
            return False

    return as_well


def match_by(turns=TURNS, shifts=SHIFTS, better=lambda found, best: found > best, update=True):
    """The best pose of the window, or a slip of it."""

    def match(field, x, y, facing, hits):
        best, most = (x, y, facing), fit_by()(field, x, y, facing, hits)
        for turned in turns:
            for dx in shifts:
                for dy in shifts:
                    pose = x + dx, y + dy, facing + turned
                    found = fit_by()(field, *pose, hits)
                    if better(found, most):
                        best = pose
                        most = found if update else most
        return best

    return match


def reference(field, x, y, facing, hits):
    """The matcher of `mapping`, with this task's window."""
    grid = Grid(5)
    grid.cells = field
    return best_match(grid, (x, y, facing), hits, WINDOW).pose


match = function(
    "match(field, x, y, facing, hits)",
    reference,
    compare=fits_as_well(FIELD, HITS),
    leaves=True,
    mistakes=[
        (
            "the guess comes back as it is: try the poses round it, and keep the best of them",
            match_by([0], [0]),
            1,
        ),
        (
            "only headings are tried: try the places of SHIFTS with each of them",
            match_by(shifts=[0]),
            1,
        ),
        ("only places are tried: try them with each heading of TURNS", match_by(turns=[0]), 1),
        (
            "the last pose that beats the guess is taken: keep the best fit so far, too",
            match_by(update=False),
            2,
        ),
        (
            "that is the pose that fits worst: the hits should agree with the field",
            match_by(better=lambda found, best: found < best),
            2,
        ),
    ],
)


GUESS = (63.5, 142.5, 40.0)
ONE_HIT = [[30, 0]]


def field_with_far_poses():
    """Near the guess the hit fits by half; at poses that mix up the guess's numbers, entirely."""
    x, y, facing = GUESS
    mixed = [(y, y, facing), (facing, y, facing), (y, x, facing), (x, x, facing)]
    mixed += [(x, facing, facing), (x, facing, y), (x, y, x), (x, y, y)]
    field = [0.0] * 1600
    for pose, value in [((x, y - 2, facing), 0.5), *((pose, 1.0) for pose in mixed)]:
        hit_x, hit_y = place(pose, (30, 0))
        field[floor(hit_y / 5) * 40 + floor(hit_x / 5)] = value
    return field


FAR_POSES = field_with_far_poses()
match_near = function(
    "match(field, x, y, facing, hits)",
    reference,
    compare=fits_as_well(FAR_POSES, ONE_HIT),
    leaves=True,
)

NOTHING = [0.0] * 1600
match_nothing = function(
    "match(field, x, y, facing, hits)",
    reference,
    compare=fits_as_well(NOTHING, ONE_HIT),
    leaves=True,
)

OTHER_TURNS, OTHER_SHIFTS = [0, -4, 4], [0, -5, 5]
in_other_windows = function(
    "match(field, x, y, facing, hits)",
    match_by(OTHER_TURNS, OTHER_SHIFTS),
    compare=fits_as_well(FIELD, HITS),
    leaves=True,
    mistakes=[
        mistake(
            f"the {what} to try were typed in: take those of {names}", slip, 1, where=lacks(read)
        )
        for what, names, slip, read in (
            ("poses", "TURNS and SHIFTS", match_by(), reads("TURNS", "SHIFTS")),
            ("headings", "TURNS", match_by(TURNS, OTHER_SHIFTS), reads("TURNS")),
            ("places", "SHIFTS", match_by(OTHER_TURNS, SHIFTS), reads("SHIFTS")),
        )
    ],
)


@check("How well hits agree with a field", hint=0)
def fits(task):
    field = [0.0] * 1600
    field[30 * 40 + 20] = 0.8  # the cell of (102.5, 152.5)
    task.call(fit, field, 102.5, 102.5, 0, [[50, 0]], gives=0.8)
    task.call(fit, field, 52.5, 152.5, 90, [[50, 0], [20, 5]], gives=0.4)
    task.call(fit, FIELD, *TRUE, HITS)


@check("Hits beyond the mat", hint=0)
def beyond(task):
    task.call(fit, [1.0] * 1600, 190, 100, 90, [[12, 0], [5, 0]], gives=0.5)
    task.call(fit, [1.0] * 1600, 100, 190, 0, [[12, 0], [5, 0]], gives=0.5)
    task.call(fit, [1.0] * 1600, 2.5, 100, 0, [[0, -5], [0, 5]], gives=0.5)
    task.call(fit, [1.0] * 1600, 100, 2.5, 0, [[-5, 0], [5, 0]], gives=0.5)


@check("The cells along the edges", hint=0)
def edges(task):
    each_its_own = [(cell + 1) / 1600 for cell in range(1600)]
    for x, y in ((2.5, 2.5), (2.5, 197.5), (197.5, 2.5), (197.5, 197.5)):
        task.call(fit, each_its_own, x, y, 0, [[0, 0]])


@check("A guess that is turned a little", hint=1)
def turned(task):
    for off in (-3, 2):
        task.call(match, FIELD, *TRUE[:2], TRUE[2] + off, HITS)


@check("A guess that is off in place, too", hint=2)
def shifted(task):
    for dx, dy, off in ((2, -2, 3), (-2, 0, -2), (0, 2, 1)):
        task.call(match, FIELD, TRUE[0] + dx, TRUE[1] + dy, TRUE[2] + off, HITS)


@check("A better pose, too far off to be tried", hint=2)
def too_far(task):
    task.call(match_near, FAR_POSES, *GUESS, ONE_HIT)


@check("Where nothing fits, and in other windows", hint=1)
def other_windows(task):
    task.call(match_nothing, NOTHING, *GUESS, ONE_HIT)
    task.set("TURNS", OTHER_TURNS)
    task.set("SHIFTS", OTHER_SHIFTS)
    for dx, dy, off in ((5, -5, 4), (-5, 0, -4)):
        task.call(in_other_windows, FIELD, TRUE[0] + dx, TRUE[1] + dy, TRUE[2] + off, HITS)
