"""A map from one spot: rooms that nobody has seen, one beam by itself, and the clamp."""

from grader import check, function
from mapping.beam import Weights, passed_by_steps
from mapping.frontiers import State
from mapping.mapper import Mapper

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
        "not one cell is black: those above KNOWN belong into the layer occupied",
        lambda run: run.map().score.occupied == 0,
        2,
    ),
    (
        "there is no unknown cell: what is between -KNOWN and KNOWN belongs into neither layer",
        lambda run: run.map().score.free + run.map().score.occupied == run.map().score.cells,
        2,
    ),
]


BEAM = (152.5, 182.5, 90, 27.0)
"""Along a row of cells, where the map of no room knows anything. Five cells, and the hit in a
sixth: whichever way the cells of a beam are listed, they are the same."""

CLOSET = "closet"
"""Here the robot sees walls close by and no more: of the rest of the mat its map knows nothing."""

FLOOR, WALL, NOTHING, NO_WALL = -0.8, 0.85, 0, "no wall"

add_beam = function("add_beam(x, y, angle, reading)", lambda *_: None, compare=lambda *_: True)


def after(beams):
    """The cells round that beam after so many times of it; None for all others."""
    mapper = Mapper(5)
    for _ in range(beams):
        mapper.add_beam(*BEAM)
    near = {row * 40 + column for row in (35, 36, 37) for column in range(29, 38)}
    return [each if cell in near else None for cell, each in enumerate(mapper.grid.cells)]


def says_the_same(wanted, got):
    """The same evidence for floor and wall, however often a rule names the cells on the way."""
    if isinstance(wanted, list):
        sound = isinstance(got, list | tuple) and len(got) == len(wanted)
        return sound and all(says_the_same(*pair) for pair in zip(wanted, got, strict=True))
    if wanted is None:
        return True
    if isinstance(got, bool) or not isinstance(got, int | float):
        return False
    if wanted == NO_WALL:
        return got <= 0
    if wanted == 0:
        return got == 0
    if abs(wanted) == L_MAX:
        return 7 <= got * wanted / L_MAX <= L_MAX + 1e-9
    return 0.6 <= got <= 0.9 if wanted > 0 else -2 <= got <= -0.2


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


@check("One beam by itself, and the clamp", hint=0)
def one_beam(task):
    task.call(add_beam, *BEAM, world=CLOSET)
    task.variable("log_odds", gives=after(1), compare=says_the_same, world=CLOSET)
    for _ in range(40):
        task.call(add_beam, *BEAM, world=CLOSET)
    task.variable("log_odds", gives=after(41), compare=says_the_same, world=CLOSET)


def only(known):
    """A map of which no more than these cells are held against the learner's."""
    return [known.get((cell % 40, cell // 40)) for cell in range(1600)]


@check("Beams aslant, beams that leave the mat, beams that find nothing", hint=0)
def more_beams(task):
    task.call(add_beam, 102.5, 102.5, 30, 60, world=CLOSET)
    known = {(23, 25): FLOOR, (26, 30): WALL}
    # To the right, to the left, up and down; where they would come out on the other side, too.
    for beam in ((187.5, 197.5, 90), (12.5, 152.5, -90), (152.5, 187.5, 0), (127.5, 12.5, 180)):
        task.call(add_beam, *beam, 22.5, world=CLOSET)
    known |= {(39, 39): FLOOR, (0, 30): FLOOR, (30, 39): FLOOR, (25, 0): FLOOR}
    known |= {(column, 29): NOTHING for column in range(35, 40)}
    known |= {(25, row): NOTHING for row in range(35, 40)}
    # Hits less than a cell off the mat are in no cell, not in the one along the edge.
    task.call(add_beam, 12.5, 162.5, -90, 15, world=CLOSET)
    task.call(add_beam, 137.5, 12.5, 180, 15, world=CLOSET)
    known |= {(0, 32): NO_WALL, (27, 0): NO_WALL}
    # Longer than FAR, and exactly as long: floor up to FAR, and no wall.
    for row, reading in ((20, 200), (22, 175), (24, 170)):
        task.call(add_beam, 12.5, 5 * row + 2.5, 90, reading, world=CLOSET)
        known |= {(column, row): FLOOR for column in (2, 10, 30)}
        known |= {(36, row): NO_WALL, (37, row): NOTHING, (38, row): NOTHING, (39, row): NOTHING}
    known |= {(23, 24): None}  # the first beam came by here
    task.variable("log_odds", gives=only(known), compare=says_the_same, world=CLOSET)
