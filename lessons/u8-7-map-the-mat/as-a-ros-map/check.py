"""image_rows(log_odds, across) and settings(image, cell_cm): a map as ROS has it in files."""

from grader import check, function
from mapping.log_odds import probability
from mapping.map_yaml import Reader
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
            "0.196 is for the greys in the file: the map itself has a cell free below 0.35",
            rows(free_p=FREE_THRESH),
            2,
        ),
    ],
)


def said(**changed):
    """The settings that are right, or a slip of them."""

    def settings(image, cell_cm):
        right = {
            "image": image,
            "resolution": cell_cm / 100,
            "origin": [0, 0, 0],
            "negate": 0,
            "occupied_thresh": OCCUPIED_THRESH,
            "free_thresh": FREE_THRESH,
        }
        return {**right, **{key: value(cell_cm) for key, value in changed.items()}}

    return settings


GREYS = [[OCCUPIED, UNKNOWN, FREE]]


def read(said):
    """What the readers of ROS make of the three greys beside these settings."""
    return [cells_of(GREYS, said, reader) for reader in Reader]


def same(expected, got):
    """Whether a map is read alike by these settings: its image, place, scale and cells."""
    try:
        return (
            got["image"] == expected["image"]
            and abs(got["resolution"] - expected["resolution"]) < 1e-9
            and list(got["origin"]) == expected["origin"]
            and read(got) == read(expected)
        )
    except (KeyError, TypeError, ValueError):
        return False


settings = function(
    "settings(image, cell_cm)",
    said(),
    compare=same,
    mistakes=[
        (
            "with that free_thresh grey 205 is read as free: its p is 50/255 = 0.196",
            said(free_thresh=lambda _: 0.25),
            2,
        ),
        ("ROS counts in metres: a cell of 5 cm has the resolution 0.05", said(resolution=float), 2),
        (
            "negate is 1 only where white is occupied: here it is 0",
            said(negate=lambda _: 1),
            2,
        ),
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
