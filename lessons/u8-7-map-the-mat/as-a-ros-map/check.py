"""image_rows(log_odds, across) and settings(image, cell_cm): a map as ROS has it in files."""

from math import isclose
from posixpath import normpath

from grader import check, function, near
from mapping.log_odds import probability
from mapping.map_yaml import Reader, settings_of
from mapping.ros_map import FREE_THRESH, OCCUPIED_THRESH, cells_of

FREE, UNKNOWN, OCCUPIED = 254, 205, 0


def rows(
    free=FREE, unknown=UNKNOWN, occupied=OCCUPIED, free_p=0.35, turned=lambda rows: rows[::-1]
):
    """What is right, or a slip of it."""

    def grey(l):
        p = probability(l)
        return occupied if p > 0.65 else free if p < free_p else unknown

    def image_rows(log_odds, across):
        greys = [grey(l) for l in log_odds]
        return turned([greys[i * across : (i + 1) * across] for i in range(across)])

    return image_rows


image_rows = function(
    "image_rows(log_odds, across)",
    rows(),
    leaves=True,
    compare=near(0),  # an array's greys may be floats
    mistakes=[
        (
            "the first row is the bottom of the map: an image begins at the top",
            rows(turned=lambda rows: rows),
            1,
        ),
        (
            "left and right are exchanged: only the order of the rows turns round",
            rows(turned=lambda rows: [row[::-1] for row in rows[::-1]]),
            1,
        ),
        (
            "columns look taken for rows: a row of the list is `across` cells side by side",
            rows(turned=lambda rows: [list(row) for row in zip(*rows, strict=True)][::-1]),
            1,
        ),
        (
            "black and white are exchanged: a dark pixel is occupied, a light one free",
            rows(free=OCCUPIED, occupied=FREE),
            0,
        ),
        ("unknown cells are drawn as free: there are three states", rows(unknown=FREE), 0),
        (
            "every row is one and the same list: `[row] * n` has one row n times, so make a new "
            "list for each row",
            lambda log_odds, across: [rows()(log_odds, across)[0]] * across,
            1,
        ),
        (
            "0.196 is for the greys in the file: the map itself has a cell free below 0.35",
            rows(free_p=FREE_THRESH),
            2,
        ),
    ],
)


NAMES = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")


def said(without=None, **changed):
    """The settings that are right, or a mistake in them."""

    def settings(image, cell_cm):
        right = {
            "image": image,
            "resolution": cell_cm / 100,
            "origin": [0, 0, 0],
            "negate": 0,
            "occupied_thresh": OCCUPIED_THRESH,
            "free_thresh": FREE_THRESH,
        }
        told = right | {name: value(cell_cm) for name, value in changed.items()}
        return {name: value for name, value in told.items() if name != without}

    return settings


def in_yaml(value):
    """A value as YAML has it: quotes stand round a text, brackets round a list."""
    if not isinstance(value, str):
        return value
    text = value.strip()
    if text[:1] + text[-1:] == "[]":
        return [in_yaml(part) for part in text[1:-1].split(",")]
    quoted = len(text) > 1 and text[0] == text[-1] and text[0] in "'\""
    return text[1:-1] if quoted else text


def read(told, reader):
    """What a reader makes of the settings and the greys of three states, or why it refuses."""
    said = {name: in_yaml(value) for name, value in told.items()}
    try:
        settings = settings_of(said, reader)
    except ValueError as error:
        return str(error).partition("; it is")[0]
    (cells,) = cells_of([[OCCUPIED, UNKNOWN, FREE]], said, reader)
    return normpath(settings.image), settings.resolution, settings.origin, cells


def read_alike(expected, got):
    """Whether every reader makes the same map of both."""
    return isinstance(got, dict) and all(
        alike(read(expected, reader), read(got, reader)) for reader in Reader
    )


def alike(one, other):
    if isinstance(one, str) or isinstance(other, str):
        return one == other
    image, side, corner, cells = one
    lengths = zip((side, *corner), (other[1], *other[2]), strict=True)
    same_place = all(isclose(a, b, rel_tol=1e-9, abs_tol=1e-9) for a, b in lengths)
    return (image, cells) == (other[0], other[3]) and same_place


READ_AS_FREE = "with that free_thresh grey 205 is read as free: its p is 50/255 = 0.196"

settings = function(
    "settings(image, cell_cm)",
    said(),
    compare=read_alike,
    mistakes=[
        (READ_AS_FREE, said(free_thresh=lambda _: 0.25), 2),
        (READ_AS_FREE, said(free_thresh=lambda _: 50 / 255), 2),
        (
            "with that occupied_thresh grey 205 is read as occupied: its p is 50/255 = 0.196",
            said(occupied_thresh=lambda _: 0.1),
            2,
        ),
        ("ROS counts in metres: a cell of 5 cm has the resolution 0.05", said(resolution=float), 2),
        (
            "0.05 was typed in: the resolution comes from cell_cm",
            said(resolution=lambda _: 0.05),
            2,
        ),
        (
            "negate is 1 only where white is occupied: here it is 0",
            said(negate=lambda _: 1),
            2,
        ),
        ("the origin has three numbers: x, y and the turn", said(origin=lambda _: [0, 0]), 2),
        *((f"the setting {name} is missing", said(without=name), 2) for name in NAMES),
    ],
)


@check("Four cells", hint=0)
def four(task):
    task.call(image_rows, [-3.0, 0.0, 2.0, -0.8], 2, gives=[[0, 254], [254, 205]])
    task.call(image_rows, [0.6, 0.7, -0.6, -0.7], 2, gives=[[205, 254], [205, 0]])


@check("A whole map", hint=1)
def whole(task):
    cells = [task.random.choice([-8.0, -1.2, 0.0, 0.45, 0.85, 8.0]) for _ in range(1600)]
    task.call(image_rows, cells, 40)


@check("Not quite free", hint=2)
def between(task):
    task.call(image_rows, [-1.2, -1.0, -0.65, -1.5, -0.5, 0, 0.65, 0.5, 1.0], 3)


@check("The settings", hint=2)
def beside(task):
    task.call(settings, "map.pgm", 5)
    task.call(settings, "flat.pgm", 10)
    task.call(settings, "lab.pgm", 2.5)
