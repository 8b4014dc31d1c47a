"""Drive 20 cm up the mat, whichever way the robot faces at first."""

from grader import check

SLIPS = [
    ("it went down: up the mat y grows", lambda run: run.path[-1][2] < 40),
    ("it drove ahead: first turn to heading 0", lambda run: run.path[-1][1] > 100, 1),
    ("it went too far", lambda run: run.path[-1][2] > 62),
    ("it never moved", lambda run: len(run.path) < 2 or run.seconds == 0),
]


@check("Up by 20 cm", hint=0)
def up(task):
    run = task.run("other-wall", seed=7, seconds=20, mistakes=SLIPS)
    _, x, y, _ = run.path[-1]
    task.near(y, 60, 1, "y at the end", run=run)
    task.near(x, 100, 1, "x at the end", run=run)
