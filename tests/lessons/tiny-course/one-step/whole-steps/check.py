"""steps(length, step): how many whole steps fit into a length."""

from math import ceil

from grader import check, function

steps = function(
    "steps(length, step)",
    lambda length, step: int(length // step),
    mistakes=[
        (
            "rounded up: a step that is only begun is no whole step",
            lambda length, step: ceil(length / step),
            1,
        ),
        (
            "rounded to the nearest whole number: what is left over must not count, however much",
            lambda length, step: round(length / step),
            1,
        ),
        (
            "not rounded at all: half a step is no step",
            lambda length, step: length / step,
            1,
        ),
        (
            "one step too many: the robot stands at the beginning of the first",
            lambda length, step: int(length // step) + 1,
            0,
        ),
    ],
)


@check("A length with a rest", hint=0)
def with_a_rest(task):
    task.call(steps, 12, 5, gives=2)
    task.call(steps, 19, 5, gives=3)


@check("A length that fits exactly", hint=0)
def exact(task):
    task.call(steps, 20, 5, gives=4)
    task.call(steps, 5, 5, gives=1)


@check("Shorter than a step, and no length at all", hint=1)
def short(task):
    task.call(steps, 3, 5, gives=0)
    task.call(steps, 0, 5, gives=0)


@check("Many lengths", hint=2)
def many(task):
    for _ in range(20):
        task.call(steps, round(task.random.uniform(0, 170), 1), task.random.choice([2.5, 5, 10]))
