"""An explorer behind doors that it has not seen, and the reason that it gives for its end."""

from math import dist

from grader import check, function
from mapping.frontiers import frontier_cells

LEFT, SMALL = "no frontier is left", "only small frontiers are left"
SHUT = "no frontier can be reached"


SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
CORNERS = [(-1, -1), (1, -1), (-1, 1), (1, 1)]


def flood(cell, cells, steps):
    """The cells connected with this one, itself among them."""
    found = [cell]
    for column, row in found:
        beside = [(column + across, row + up) for across, up in steps]
        found += [each for each in beside if each in cells and each not in found]
    return set(found)


def regions_of(cells):
    left, regions = set(cells), []
    while left:
        regions.append(flood(min(left), left, SIDES + CORNERS))
        left -= regions[-1]
    return regions


def near(cell, cells):
    return any(5 * dist(cell, each) < 12 for each in cells)


def chosen(
    large=lambda size: size >= 5, leave=True, steps=SIDES, left=LEFT, small=SMALL, shut=SHUT
):
    """The one goal there is, or the reason why there is none; or what a mistake makes of it."""

    def choose_goal(here, frontier, room, tried):
        wanted = frontier - tried if leave else frontier
        regions = [each for each in regions_of(wanted) if large(len(each))]
        if not (frontier if left == LEFT else wanted):
            return None, LEFT
        if not regions:
            return None, small
        reached = room if steps is None else flood(here, room, steps)
        spots = [cell for cell in reached if any(near(cell, each) for each in regions)]
        return (min(spots), None) if spots else (None, shut)

    return choose_goal


choose_goal = function(
    "choose_goal(here, frontier, room, tried)",
    chosen(),
    cell_cm=5,
    leaves=True,
    mistakes=[
        (
            "cells that were tried count again: take the regions of frontier - tried",
            chosen(leave=False),
            0,
        ),
        ("a region of exactly MIN_REGION cells is large enough", chosen(lambda size: size > 5), 0),
        ("small regions count: leave out those of fewer cells", chosen(lambda size: True), 0),
        ("a cell with room need not be in reach: flood the room from here", chosen(steps=None), 0),
        (
            "it goes round corners without room: flood the room by SIDES alone",
            chosen(steps=SIDES + CORNERS),
            0,
        ),
        (
            "it looks from its own cell alone: flood the room from here, by SIDES",
            chosen(steps=[]),
            0,
        ),
        ("small regions are frontiers too: only small ones are left", chosen(small=LEFT), 1),
        (
            "there are large regions, and none can be reached: that is a reason of its own",
            chosen(shut=SMALL),
            1,
        ),
        (
            "what was tried is frontier still: none is left only if frontier is empty",
            chosen(left="no region"),
            1,
        ),
    ],
)

choose_goal_of_3 = function(
    "choose_goal(here, frontier, room, tried)",
    chosen(lambda size: size >= 3),
    cell_cm=5,
    leaves=True,
    mistakes=[
        ("regions count from MIN_REGION cells on, and here they count from 5 on", chosen(), 0)
    ],
)


def said(run):
    """The reason that the program printed, or nothing."""
    return run.console.rpartition("The robot stops:")[2].strip().rstrip(".")


def went(run):
    """How far the robot came from its start [cm], at the most."""
    _, x, y, _ = run.path[0]
    return max(((a - x) ** 2 + (b - y) ** 2) ** 0.5 for _, a, b, _ in run.path)


SLIPS = [
    (
        "not one cell is black: the cells above KNOWN are walls, and belong in the layer occupied",
        lambda run: run.map().score.occupied == 0,
    ),
    (
        "it looked round and went nowhere: choose_goal has to find a cell to go to",
        lambda run: went(run) < 5 and "nobody" in said(run),
        0,
    ),
    (
        "it looked round once and stopped: does explore() go on in a loop?",
        lambda run: went(run) < 5 and said(run) not in (LEFT, SMALL, SHUT),
        2,
    ),
    (
        "it went to one goal and stopped there: after a goal comes the next one",
        lambda run: went(run) > 5 and run.seconds < 20 and said(run) not in (LEFT, SMALL, SHUT),
        2,
    ),
]


def explores(task, world, seed):
    run = task.run(world, seed=seed, seconds=150, mistakes=SLIPS)
    run.bumped(at_most=2)
    return run


def says(task, run, reasons):
    why = said(run)
    task.expect(
        why in reasons,
        expected=" or ".join(f'"The robot stops: {reason}."' for reason in reasons),
        got=f'"The robot stops: {why}."' if why else "no line with The robot stops:",
        run=run,
        likely=_why_not(why, reasons),
        hint=1,
    )
    drawn = run.map()
    some = frontier_cells(drawn.grid, drawn.states)
    task.expect(
        not (why == LEFT and some),
        expected=f"another reason: {len(some)} frontier cells are on its last map",
        got=f'"The robot stops: {why}."',
        run=run,
        cells=[drawn.grid.cell(index) for index in some],
        likely="small regions are frontiers too: that none is left is only true without any",
        hint=1,
    )


def _why_not(why, reasons):
    if SHUT in reasons and why in (LEFT, SMALL):
        return "there are large frontiers behind the hatch: it can see them and not reach them"
    if SHUT in reasons and why == "time is up":
        return "it tries to reach what can't be reached: only cells in reach can be goals"
    return None


CORRIDOR = {(column, 2) for column in range(2, 9)}
END = {(10, row) for row in range(5)}  # two cells from the corridor's last one, three from the next


def corridor(task):
    """The map is handed in, so the robot need not explore for it."""
    task.set("MAX_TIME", 0)


@check("A corridor with one place to look from", hint=0)
def one_spot(task):
    corridor(task)
    here = (2, 2)
    task.call(choose_goal, here, END, CORRIDOR, set(), gives=((8, 2), None))
    task.call(choose_goal, here, END | {(2, 19)}, CORRIDOR, {(2, 19)}, gives=((8, 2), None))
    slanting = {(10 + i, 2 + i) for i in range(5)}
    task.call(choose_goal, here, slanting, CORRIDOR, set(), gives=((8, 2), None))
    beyond = {(column, 12) for column in range(12)} | {(6, 0), (6, 1), (6, 3), (6, 4)}
    task.call(choose_goal, here, beyond | END, CORRIDOR, set(), gives=((8, 2), None))
    task.call(choose_goal, (8, 2), END, CORRIDOR, set(), gives=((8, 2), None))


@check("A corridor without", hint=1)
def no_spot(task):
    corridor(task)
    here = (2, 2)
    task.call(choose_goal, here, set(), CORRIDOR, set(), gives=(None, LEFT))
    task.call(choose_goal, here, END - {(10, 2)} - {(10, 0)}, CORRIDOR, set(), gives=(None, SMALL))
    task.call(choose_goal, here, END - {(10, 0)}, CORRIDOR, set(), gives=(None, SMALL))
    task.call(choose_goal, here, END, CORRIDOR, {(10, 4)}, gives=(None, SMALL))
    task.call(choose_goal, here, END, CORRIDOR, END, gives=(None, SMALL))
    task.call(choose_goal, here, END, CORRIDOR - {(5, 2)}, set(), gives=(None, SHUT))
    round_a_corner = CORRIDOR - {(5, 2)} | {(5, 3)}
    task.call(choose_goal, here, END, round_a_corner, set(), gives=(None, SHUT))
    task.call(choose_goal, here, END, CORRIDOR - {(8, 2)}, set(), gives=(None, SHUT))


@check("The same corridor with MIN_REGION = 3", hint=0)
def smaller_regions(task):
    corridor(task)
    task.set("MIN_REGION", 3)
    three = {(10, row) for row in (1, 2, 3)}
    task.call(choose_goal_of_3, (2, 2), three, CORRIDOR, set(), gives=((8, 2), None))
    task.call(choose_goal_of_3, (2, 2), three - {(10, 1)}, CORRIDOR, set(), gives=(None, SMALL))


@check("The doorway, with other noise", hint=0)
def doorway(task):
    run = explores(task, "doorway", 61)
    run.visits(lambda x, y: y > 128, "the room behind the doorway")
    run.map().cells_of(5).known(at_least=88).wrong_walls(at_most=8)
    says(task, run, [LEFT, SMALL])


@check("Three rooms in a row", hint=2)
def three_rooms(task):
    run = explores(task, "three-in-a-row", 62)
    run.visits(lambda x, y: y > 141, "the last room")
    run.map().cells_of(5).known(at_least=85).wrong_walls(at_most=8)
    says(task, run, [LEFT, SMALL])


@check("A room with a hatch", hint=1)
def hatch(task):
    run = explores(task, "hatch", 63)
    run.map().cells_of(5).known(at_least=50).wrong_walls(at_most=8)
    says(task, run, [SHUT])
