"""An explorer behind doors that it has not seen, and the reason that it gives for its end."""

from grader import check
from mapping.frontiers import frontier_cells

LEFT, SMALL = "no frontier is left", "only small frontiers are left"
SHUT = "no frontier can be reached"


def said(run):
    """The reason that the program printed, or nothing."""
    return run.console.rpartition("The robot stops:")[2].strip().rstrip(".")


def went(run):
    """How far the robot came from its start [cm], at the most."""
    _, x, y, _ = run.path[0]
    return max(((a - x) ** 2 + (b - y) ** 2) ** 0.5 for _, a, b, _ in run.path)


SLIPS = [
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
    (
        "it says that nothing can be reached, and it never left: "
        "was the flood through room begun at here, by SIDES?",
        lambda run: went(run) < 5 and said(run) == SHUT,
        0,
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
