"""fit() and match() on small fields, and on one made from a map."""

import ast
from itertools import permutations, product
from math import cos, floor, radians, sin

from grader import calls, check, function, lacks, mistake, near, reads
from mapping.grid import Grid
from mapping.mapper import Mapper
from mapping.matching import Window, likelihoods, place
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


def off_the_edges(field, x, y):
    """Column 0 and row 0 left out."""
    return cell_value(field, x, y) if x >= 5 and y >= 5 else 0


def by_index_alone(field, x, y):
    """What the list gives, which has negative indices too."""
    index = floor(y / 5) * 40 + floor(x / 5)
    return field[index] if -1600 <= index < 1600 else 0


def wrong_side(pose, hit):
    """A point on the mat, its y with the wrong sign before what is to the right."""
    (x, y), (_, straight) = place(pose, hit), place(pose, (hit[0], 0))
    return x, 2 * straight - y


def of_each_cell_once(field, x, y, facing, hits):
    cells = {tuple(floor(each / 5) for each in place((x, y, facing), hit)) for hit in hits}
    values = [cell_value(field, 5 * column + 1, 5 * row + 1) for column, row in cells]
    return sum(values) / len(values)


def nothing_if_any_is_beyond(field, x, y, facing, hits):
    points = [place((x, y, facing), hit) for hit in hits]
    on_it = all(0 <= x < 200 and 0 <= y < 200 for x, y in points)
    return fit_by()(field, x, y, facing, hits) if on_it else 0


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
            "int() cuts -0.5 off to 0, so a hit just off the mat gets a cell: use math.floor()",
            fit_by(truncated),
            0,
            where=calls("int"),
        ),
        (
            "hits in one cell were counted once: each of them counts",
            of_each_cell_once,
            0,
        ),
        (
            "column 0 and row 0 are on the mat: 0 must pass the test",
            fit_by(off_the_edges),
            0,
        ),
        (
            "the list was asked, and not the mat: left and right of the mat the index is that of "
            "another row; ask whether column and row are from 0 to ACROSS - 1",
            fit_by(by_index_alone),
            0,
        ),
        (
            "one hit beyond the mat, and the answer is 0: it adds 0, but the others still count",
            nothing_if_any_is_beyond,
            0,
        ),
        (
            "ahead and right have changed places: a hit is (ahead, right)",
            fit_by(seen=lambda pose, hit: place(pose, hit[::-1])),
            0,
        ),
        (
            "what is to the robot's right lies on the wrong side in y: on_mat() has the right sign",
            fit_by(seen=wrong_side),
            0,
        ),
        *(
            (
                "the mean was rounded: return it with all its decimals",
                lambda *given, digits=digits: round(fit_by()(*given), digits),
                0,
            )
            for digits in (2, 1, 3)
        ),
    ],
)


TRUE = (104.0, 97.0, 20.0)
BOXES = [(120, 140, 40, 10), (40, 60, 10, 40)]


def reach(x, y, facing):
    """How far one sees in that direction [cm], in steps of half a centimetre."""
    steps = (half / 2 for half in range(1, 400))
    return next(far for far in steps if gap_cm(*place((x, y, facing), (far, 0)), BOXES) <= 0.5)


def scene():
    """A map's field, and what a robot at TRUE sees: points of the walls, no two alike.

    They lie in cells of which the map is certain, so TRUE fits by 1, and every pose beside it less.
    """
    mapper = Mapper()
    for facing in range(0, 360, 3):
        mapper.add_scan(100, 100, facing, 4 * [(0, min(150.0, reach(100, 100, facing)))])
    field = likelihoods(mapper.grid).cells
    hits = []
    for cell in [cell for cell, value in enumerate(field) if value == 1][::3]:
        across, up = 0.1 + len(hits) * 0.618 % 0.8, 0.1 + len(hits) * 0.414 % 0.8
        east, north = 5 * (cell % 40 + across) - TRUE[0], 5 * (cell // 40 + up) - TRUE[1]
        sine, cosine = sin(radians(TRUE[2])), cos(radians(TRUE[2]))
        hits.append([east * sine + north * cosine, east * cosine - north * sine])
    return field, hits


FIELD, HITS = scene()


def fits_as_well(field, hits):
    """Any pose that fits as well as the best one of the window will do."""

    def as_well(wanted, got):
        if not isinstance(wanted, list | tuple) or len(wanted) != 3:  # a slip's answer
            return near(0.000001)(wanted, got)
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


def facing_of_the_guess(field, x, y, facing, hits):
    return *match_by()(field, x, y, facing, hits)[:2], facing


def with_its_fit(field, x, y, facing, hits):
    pose = match_by()(field, x, y, facing, hits)
    return fit_by()(field, *pose, hits), *pose


def both_alike(field, x, y, facing, hits):
    """The same shift for x and for y."""
    poses = [(x + shift, y + shift, facing + turned) for turned in TURNS for shift in SHIFTS]
    return max(poses, key=lambda pose: fit_by()(field, *pose, hits))


def from_the_best_so_far(field, x, y, facing, hits):
    best = x, y, facing
    for turned, dx, dy in product(TURNS, SHIFTS, SHIFTS):
        pose = best[0] + dx, best[1] + dy, best[2] + turned
        best = max(best, pose, key=lambda pose: fit_by()(field, *pose, hits))
    return best


def one_after_the_other(order):
    """Each of the three numbers is settled before the next is tried."""

    def match(field, *given):
        *pose, hits = given
        for part in order:
            steps = OTHER_TURNS if part == 2 else OTHER_SHIFTS
            tried = [[*pose[:part], pose[part] + step, *pose[part + 1 :]] for step in steps]
            pose = max(tried, key=lambda pose: fit_by()(field, *pose, hits))
        return pose

    return match


def ends_at_a_better_one(field, x, y, facing, hits):
    """A break after the first better place of a row ends that row."""
    best = x, y, facing
    for turned, dx in product(TURNS, SHIFTS):
        for dy in SHIFTS:
            pose = x + dx, y + dy, facing + turned
            if fit_by()(field, *pose, hits) > fit_by()(field, *best, hits):
                best = pose
                break
    return best


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
        (
            "only the pose is wanted: (x, y, facing), without its fit",
            with_its_fit,
            2,
        ),
        (
            "the heading that comes back is the guess's: keep facing + turned with its x and y",
            facing_of_the_guess,
            2,
        ),
        (
            "x and y are always moved alike: try each shift along x with each along y",
            both_alike,
            1,
        ),
        (
            "each step goes on from the best pose so far: try all of them from the guess",
            from_the_best_so_far,
            1,
        ),
        mistake(
            "the first better place ends its row of places, and those after it are not tried: go "
            "on, a later one may be better still",
            ends_at_a_better_one,
            2,
            where=lambda text: any(isinstance(node, ast.Break) for node in text.nodes),
        ),
        mistake(
            "range(-3, 3) ends with 2: take the headings from TURNS",
            match_by(turns=range(-3, 3)),
            1,
            where=calls("range"),
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
    ]
    + [
        (
            "x, y and heading are settled one after the other: try every heading with every place",
            one_after_the_other(order),
            1,
        )
        for order in permutations(range(3))
    ],
)


@check("How well hits agree with a field", hint=0)
def fits(task):
    field = [0.0] * 1600
    field[30 * 40 + 20] = 0.8  # the cell of (102.5, 152.5)
    task.call(fit, field, 102.5, 102.5, 0, [[50, 0]], gives=0.8)
    task.call(fit, field, 52.5, 152.5, 90, [[50, 0], [20, 5]], gives=0.4)
    task.call(fit, field, 102.5, 102.5, 0, [[50, 0], [51, 0], [20, 0]], gives=1.6 / 3)
    task.call(fit, FIELD, *TRUE, HITS)
    task.call(fit, FIELD, TRUE[0] + 6, TRUE[1], TRUE[2] + 3, HITS)


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
    task.call(match, FIELD, *TRUE, HITS)  # no pose beats the guess itself
    for off in (-3, 2, 3):
        task.call(match, FIELD, *TRUE[:2], TRUE[2] + off, HITS)


@check("A guess that is off in place, too", hint=2)
def shifted(task):
    for dx, dy, off in ((2, -2, 3), (-2, 0, -3), (0, 2, 1), (0, -2, 2), (2, 2, -2)):
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
