"""A run's own looks with a drift put in: what is wrong with each map is worked out anew here."""

from grader import check, function, near
from mapping.frontiers import known_states
from mapping.mapper import Mapper
from mapping.score import score

DRIFTS = [0, 0.5, 1, 2, 3]


def wrong_with(run, added):
    """How much of the map is wrong if `added(t)` degrees are added to the heading of each look."""
    mapper = Mapper()
    for look in run.scans:
        mapper.add_scan(look.x, look.y, look.heading + added(look.t), look.beams)
    states = known_states(mapper.grid.cells)
    return score(mapper.grid, states, run.obstacles).wrong_walls_percent


def printed(run):
    return [run.number_after(f"drift {rate}:") for rate in DRIFTS]


def slip(said, hint, turned):
    """A slip that shows in the numbers: `turned(i, t)` is how far it takes the i-th drift to be."""

    def looks_so(run):
        wanted = [wrong_with(run, lambda t, i=i: turned(i, t)) for i in range(len(DRIFTS))]
        return all(abs(a - b) < 0.2 for a, b in zip(printed(run), wanted))

    return said, looks_so, hint


SLIPS = [
    (
        "all the numbers are the same: make each map from drifted(looks, rate)",
        lambda run: len(set(printed(run))) == 1,
        2,
    ),
    slip(
        "a drift grows with time: after t seconds it is rate * t",
        0,
        lambda i, t: DRIFTS[i],
    ),
    slip(
        "the drift has the wrong sign: it is added to the heading",
        0,
        lambda i, t: -DRIFTS[i] * t,
    ),
    slip(
        "rate is per second, not per look: each look brings its own time",
        0,
        lambda i, t: DRIFTS[i] * 10 * t,
    ),
    slip(
        "each drift is added to the looks that have drifted already: begin with `looks` each time",
        1,
        lambda i, t: sum(DRIFTS[: i + 1]) * t,
    ),
]


drifted = function(
    "drifted(looks, rate)",
    lambda looks, rate: [(t, facing + rate * t, readings) for t, facing, readings in looks],
    compare=near(1e-6),
    mistakes=[
        (
            "a drift grows with time: after t seconds it is rate * t",
            lambda looks, rate: [(t, facing + rate, readings) for t, facing, readings in looks],
            0,
        ),
        (
            "the drift has the wrong sign: it is added to the heading",
            lambda looks, rate: [(t, facing - rate * t, rest) for t, facing, rest in looks],
            0,
        ),
        (
            "the rate is per second, not per look: each look brings its own time",
            lambda looks, rate: [
                (t, facing + rate * i, rest) for i, (t, facing, rest) in enumerate(looks)
            ],
            0,
        ),
    ],
)


@check("Looks with a drift to either side", hint=1)
def either_side(task):
    looks = [
        [t, task.random.uniform(0, 360), [[-19.6875, 80.5], [2.8125, 200.0]]] for t in (0, 2, 5.5)
    ]
    for rate in (-0.7, 0, 1.25):
        task.call(drifted, looks, rate)
    task.call(drifted, [], 1)


@check("The damage for each drift", hint=2)
def each(task):
    run = task.run("hall", seed=41, seconds=60, mistakes=SLIPS)
    for rate, got in zip(DRIFTS, printed(run)):
        wanted = wrong_with(run, lambda t, rate=rate: rate * t)
        task.near(got, wanted, 0.2, f"the share of wrong walls with a drift of {rate}", run=run)


@check("The map of the last drift, drawn", hint=2)
def drawn(task):
    run = task.run("hall", seed=41, seconds=60, mistakes=SLIPS)
    black, red = run.layer("occupied"), run.layer("wrong")
    share = 100 * len(red) / max(1, len(black))
    wanted = wrong_with(run, lambda t: DRIFTS[-1] * t)
    task.near(share, wanted, 0.2, "the share of red dots on the map of the last drift", run=run)
    both = len(set(run.layer("free")) & set(black))
    task.expect(
        not both,
        expected="no cell drawn both free and black",
        got=f"{both} cells are drawn as both: show() wants the free cells first",
        run=run,
    )
