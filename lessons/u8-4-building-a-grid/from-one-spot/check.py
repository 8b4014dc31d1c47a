"""A map from one spot: rooms that nobody has seen, one beam by itself, and the clamp."""

from math import ceil, cos, floor, inf, radians, sin

from grader import between, calls, check, function, mistake, operator
from mapping.beam import Weights, passed_by_steps
from mapping.frontiers import State

KNOWN = 1
L_MAX = 8


def into_the_hit(x, y, angle, length, cell):
    return passed_by_steps(x, y, angle, length + cell if length < 165 else length, cell)


def slip(said, hint, **how):
    """A slip that shows in the map: how the reference would have to be changed to draw it."""
    return (said, lambda run: run.map().looks_like(run.mapped(**how)), hint)


SLIPS = [
    (
        "no time passes, so the robot never turns: the loop needs its wait(0.1)",
        lambda run: run.seconds < 1,
        2,
    ),
    slip(
        "sine and cosine look swapped: x goes by sine and y by cosine",
        0,
        seen_as=lambda x, y, heading, angle, reading: (x, y, 90 - heading, -angle, reading),
    ),
    slip(
        "the heading is left out: a beam's direction is heading() + angle",
        1,
        seen_as=lambda x, y, heading, angle, reading: (x, y, 0, angle, reading),
    ),
    slip(
        "position() is from where the robot started: add START to get the place on the mat",
        1,
        seen_as=lambda x, y, heading, angle, reading: (x - 45, y - 30, heading, angle, reading),
    ),
    slip(
        "row and column look swapped: cell number row * ACROSS + column",
        2,
        seen_as=lambda x, y, heading, angle, reading: (y, x, 90 - heading, -angle, reading),
    ),
    slip(
        "the maximum is taken for a wall: a reading of FAR or more marks no hit",
        0,
        weights=Weights(far_cm=1000),
    ),
    slip(
        "readings of FAR or more are thrown away: they mark "
        "no wall, but their floor is free up to FAR",
        0,
        seen_as=lambda x, y, heading, angle, reading: (
            (x, y, heading, angle, reading) if reading < 170 else None
        ),
    ),
    slip(
        "the hit cell is marked free as well: stop one cell short of the hit",
        0,
        passed_by=into_the_hit,
    ),
    slip(
        "the hits are never added: L_OCC goes into the cell where the beam ended",
        0,
        weights=Weights(l_occ=0),
    ),
    slip(
        "the passes are never added: L_FREE goes into the cells on the way",
        0,
        weights=Weights(l_free=0),
    ),
    slip(
        "the layers show every cell that has any evidence: known means beyond KNOWN, either way",
        2,
        known=0.001,
    ),
    (
        "not one cell is black: those above KNOWN belong in the layer occupied",
        lambda run: run.map().score.occupied == 0,
        2,
    ),
    (
        "there is no unknown cell: what is between -KNOWN and KNOWN belongs in neither layer",
        lambda run: run.map().score.free + run.map().score.occupied == run.map().score.cells,
        2,
    ),
]


BEAM = (152.5, 182.5, 90, 27)
"""Along a row of cells, where the map of no room knows anything. Five cells, and the hit in a
sixth: whichever way the cells of a beam are listed, they are the same."""

ASLANT = (102.5, 102.5, 30, 60)

CLOSET = "closet"
"""Here the robot sees walls close by and no more: of the rest of the mat its map knows nothing."""

# The same evidence for floor and wall, however often a rule names the cells on the way.
FLOOR = between(-2, -0.2, "evidence of floor, about -0.8,")
WALL = between(0.6, 1.2, "evidence of a wall, 0.85,")
NO_WALL = between(-inf, 0, "0 or less (no wall)")
NOTHING = between(0, 0, "0 (no evidence)")
LOWEST = between(-L_MAX, -L_MAX + 1, "-8 (the clamp)")
HIGHEST = between(L_MAX - 1, L_MAX, "8 (the clamp)")

add_beam = function("add_beam(x, y, angle, reading)", lambda *_: None, compare=lambda *_: True)


ANYTHING = between(-inf, inf)


def a_map(known):
    """A map of which no more than these cells are held against the learner's."""
    return [known.get((cell % 40, cell // 40), ANYTHING) for cell in range(1600)]


def half_cells(clear, whole=int):
    """How far the half-cell steps are along the beam; rules differ in the last of them."""
    return [i * 2.5 for i in range(whole(clear / 2.5))]


def up_to_the_hit(reading):
    return 170 if reading >= 170 else reading - 5


def inside(x, y):
    column, row = floor(x / 5), floor(y / 5)
    return row * 40 + column if 0 <= column < 40 and 0 <= row < 40 else None


def clamped(before, weight):
    return max(-L_MAX, min(L_MAX, before + weight))


def wrapped(x, y):
    index = floor(y / 5) * 40 + floor(x / 5)
    return index if 0 <= index < 1600 else None


def row_alone(x, y):
    return wrapped(x, y) if 0 <= y < 200 else None


def truncated(x, y):
    column, row = int(x / 5), int(y / 5)
    return row * 40 + column if 0 <= column < 40 and 0 <= row < 40 else None


def left_by(
    beams,
    direction=lambda angle: (sin(radians(angle)), cos(radians(angle))),
    clear=up_to_the_hit,
    steps=half_cells,
    hit=lambda reading: reading < 170,
    cell=inside,
    put=clamped,
    weights=(-0.4, 0.85),
    once=False,
    last_step=int,
):
    """What these beams leave in the map, where the closet is far; the others are a slip's."""
    log_odds = [0.0] * 1600
    for x, y, angle, reading in beams:
        dx, dy = direction(angle)
        evidence = [(along, weights[0]) for along in steps(clear(reading), last_step)]
        evidence += [(reading, weights[1])] if hit(reading) else []
        seen = set()
        for along, weight in evidence:
            index = cell(x + along * dx, y + along * dy)
            if index is not None and not (once and (index, weight) in seen):
                log_odds[index] = put(log_odds[index], weight)
            seen.add((index, weight))
    return [
        each if cell % 40 > 21 or cell // 40 > 21 or cell == 0 else ANYTHING
        for cell, each in enumerate(log_odds)
    ]


SIDES = "check that column and row are both from 0 to ACROSS - 1"
LEAVES = [
    # What the learner is told, what must stand there, the slip.
    (
        "sine and cosine are the wrong way round: x goes by sine and y by cosine",
        (calls("sin"), calls("cos")),
        {"direction": lambda angle: (cos(radians(angle)), sin(radians(angle)))},
    ),
    (
        "degrees were taken for radians: math.sin() and math.cos() want math.radians(angle)",
        calls("sin", "cos", "exp", "rect"),
        {"direction": lambda angle: (sin(angle), cos(angle))},
    ),
    (
        "the angle was counted the other way: clockwise means that x grows with the sine",
        (),
        {"direction": lambda angle: (sin(radians(-angle)), cos(radians(angle)))},
    ),
    (
        "row and column are the wrong way round: the cell's number is row * ACROSS + column",
        (),
        {"cell": lambda x, y: inside(y, x)},
    ),
    (
        "the steps are a whole cell long and jump over corners: go by half cells",
        (),
        {"steps": lambda clear, whole: half_cells(clear, whole)[::2]},
    ),
    (
        "a cell is counted only once per beam: give it L_FREE at every half-cell step",
        (),
        {"once": True},
    ),
    (
        "the steps go on to the hit itself: stop one cell short of it",
        (),
        {"clear": lambda reading: min(170, reading)},
    ),
    (
        "the maximum was taken for a wall: a reading of FAR or more marks no hit",
        (),
        {"clear": lambda reading: reading - 5, "hit": lambda reading: True},
    ),
    (
        "a reading of FAR or more marks no hit: it found nothing",
        (),
        {"hit": lambda reading: True},
    ),
    (
        "a reading of exactly FAR has found nothing either: a hit is less than FAR",
        (),
        {"hit": lambda reading: reading <= 170},
    ),
    (
        "a reading of FAR or more was left out: it says that the floor is free up to FAR",
        (),
        {"clear": lambda reading: 0 if reading >= 170 else reading - 5},
    ),
    (
        "the clear length of a reading of FAR or more is FAR, not the reading",
        (),
        {"clear": lambda reading: reading if reading >= 170 else reading - 5},
    ),
    (
        "there is no clamp: keep every cell between -L_MAX and L_MAX",
        (),
        {"put": lambda before, weight: before + weight},
    ),
    (
        "only the top is clamped: a cell may not fall below -L_MAX either",
        (),
        {"put": lambda before, weight: min(L_MAX, before + weight)},
    ),
    (
        "only the bottom is clamped: a cell may not rise above L_MAX either",
        (),
        {"put": lambda before, weight: max(-L_MAX, before + weight)},
    ),
    (
        "the evidence took the place of what was there: add it to the cell's log odds",
        (),
        {"put": lambda before, weight: weight},
    ),
    (
        "L_FREE was subtracted: it is negative already, so add it",
        operator("-"),
        {"weights": (0.4, 0.85)},
    ),
    (
        "the hit is missing: after the floor, L_OCC in the cell where the beam ended",
        (),
        {"hit": lambda reading: False},
    ),
    (
        "the floor is missing: L_FREE at every half-cell step",
        (),
        {"weights": (0, 0.85)},
    ),
    (
        "the hit gave 0.4: its evidence is L_OCC",
        (),
        {"weights": (-0.4, 0.4)},
    ),
    (
        f"a point off the mat came out on the other side: {SIDES}",
        (),
        {"cell": wrapped},
    ),
    (
        f"only the row is checked: {SIDES}",
        (),
        {"cell": row_alone},
    ),
    (
        "int() cuts -0.4 down to 0, so a point just off the mat gets a cell: use math.floor()",
        calls("int"),
        {"cell": truncated},
    ),
    (
        "cell number 0, at the bottom left, was left out: an if on its number takes 0 for no",
        (),
        {"cell": lambda x, y: inside(x, y) or None},
    ),
]


def mistakes_with(beams):
    """The slips, each by what it leaves after just these beams."""
    return [
        mistake(
            said,
            lambda how=how, last_step=last_step: left_by(beams, last_step=last_step, **how),
            0,
            where=where,
        )
        for said, where, how in LEAVES
        for last_step in (int, ceil)
    ]


def mapped_well(task, world, seed, known):
    run = task.run(world, seed=seed, seconds=30, mistakes=SLIPS)
    drawn = run.map(known=KNOWN)
    drawn.cells_of(5).known(at_least=known).wrong_walls(at_most=4).wrong_floor(at_most=1)
    # Limits with room for every sound rule: lessons/README.md, "How maps are judged".
    drawn.walls_found(at_least=45).plain(floor_at_least=94, walls_at_least=85)
    if "occupied" in run.layers(0.05):
        one_hit_is_not_enough(task, run)
    return drawn


def one_hit_is_not_enough(task, run):
    """After one scan hardly a cell can be black: a hit is less than KNOWN, whatever the rule."""
    drawn = run.map(at=0.05)
    black = [drawn.grid.cell(i) for i, s in enumerate(drawn.states) if s is State.OCCUPIED]
    ended = run.evidence(drawn.grid, 0.05).ended
    hits = [drawn.grid.cell(i) for i, count in enumerate(ended) for _ in range(count)]
    once = [
        (column, row)
        for column, row in black
        if sum(max(abs(column - c), abs(row - r)) <= 1 for c, r in hits) < 2
    ]
    task.expect(
        2 * len(once) <= len(black),
        expected="no cell black after a single hit: that is 0.85, which is not above 1",
        got=f"{len(once)} of {len(black)} black cells had one hit when they were first drawn",
        run=run,
        cells=once,
        seconds=0.05,
    )


DRAWN = {
    State.FREE: "below -1, as the cell is drawn free",
    State.OCCUPIED: "above 1, as the cell is drawn occupied",
    State.UNKNOWN: "between -1 and 1, as the cell is not drawn",
}


def is_as_drawn(wanted, got):
    if isinstance(wanted, list):
        sound = isinstance(got, list | tuple) and len(got) == len(wanted)
        return sound and all(is_as_drawn(*pair) for pair in zip(wanted, got, strict=True))
    if isinstance(got, bool) or not isinstance(got, int | float):
        return False
    # Sums of floats that are 1 on paper may come out on either side.
    if wanted == DRAWN[State.FREE]:
        return got < -KNOWN + 1e-9
    if wanted == DRAWN[State.OCCUPIED]:
        return got > KNOWN - 1e-9
    return abs(got) < KNOWN + 1e-9


@check("The room of the page, with other noise", hint=0)
def same_room(task):
    drawn = mapped_well(task, "corner-room", 31, known=54)
    # The same run again: the layers have to show what the program's own numbers say.
    drawn_as = [DRAWN[state] for state in drawn.states]
    task.variable("log_odds", gives=drawn_as, compare=is_as_drawn, world="corner-room", seed=31)


@check("A den, the robot facing right", hint=1)
def den(task):
    mapped_well(task, "den", 32, known=58)


@check("A stock room, the robot facing down and left", hint=1)
def stock_room(task):
    mapped_well(task, "stock-room", 33, known=47)


def look_at(task, beams, known):
    task.variable(
        "log_odds",
        gives=a_map(known),
        world=CLOSET,
        mistakes=mistakes_with(beams),
        grid_cm=5,
    )


@check("One beam by itself, and the clamp", hint=0)
def one_beam(task):
    task.call(add_beam, *BEAM, world=CLOSET)
    on_its_way = [(column, 36) for column in range(30, 35)]
    around = {(column, row): NOTHING for column in range(29, 38) for row in (35, 36, 37)}
    look_at(task, [BEAM], around | dict.fromkeys(on_its_way, FLOOR) | {(35, 36): WALL})
    for _ in range(40):
        task.call(add_beam, *BEAM, world=CLOSET)
    look_at(task, 41 * [BEAM], around | dict.fromkeys(on_its_way, LOWEST) | {(35, 36): HIGHEST})


def row_of_cells(columns, rows):
    return {(column, row): NOTHING for column in columns for row in rows}


BEAMS = [
    (ASLANT, {(23, 25): FLOOR, (26, 30): WALL}),
    # To the right, to the left, up and down; where they would come out on the other side, too.
    ((187.5, 197.5, 90, 22.5), {(39, 39): FLOOR}),
    ((12.5, 152.5, -90, 22.5), {(0, 30): FLOOR, **row_of_cells(range(35, 40), [29])}),
    ((152.5, 187.5, 0, 22.5), {(30, 39): FLOOR}),
    ((127.5, 12.5, 180, 22.5), {(25, 0): FLOOR, **row_of_cells([25], range(35, 40))}),
    # Hits less than a cell off the mat are in no cell, not in the one along the edge.
    ((12.5, 162.5, -90, 15), {(0, 32): NO_WALL}),
    ((137.5, 12.5, 180, 15), {(27, 0): NO_WALL}),
    # Through the corner at the bottom left, cell number 0, which lies behind the closet's wall.
    ((12.5, 12.5, 225, 30), {(0, 0): FLOOR}),
    # Longer than FAR, and exactly as long: floor up to FAR, and no wall.
    *(
        (
            (12.5, 5 * row + 2.5, 90, reading),
            {
                **{(column, row): FLOOR for column in (2, 10, 30)},
                (36, row): NO_WALL,
                **row_of_cells((37, 38, 39), [row]),
                (23, 24): ANYTHING,  # the first beam came by here
            },
        )
        for row, reading in ((20, 200), (22, 175), (24, 170))
    ),
]


@check("Beams aslant, beams that leave the mat, beams that find nothing", hint=0)
def more_beams(task):
    put_in, known = [], {}
    for beam, cells in BEAMS:
        task.call(add_beam, *beam, world=CLOSET)
        put_in.append(beam)
        known |= cells
        look_at(task, list(put_in), dict(known))
