"""wall_direction(looks) and drift_rate(first, second, seconds), and the drift of a whole run."""

from math import atan, atan2, cos, degrees, pi, radians, sin

from grader import calls, check, function, mistake, near, number

FAN = [-19.6875 + 5.625 * i for i in range(8)]


def line_by(facing=lambda facing: facing, far=170, mean=True, angle=None):
    """The direction of the line through all hits, or a slip of it."""

    def wall_direction(looks):
        points = [
            (reading * sin(radians(facing(h) + a)), reading * cos(radians(facing(h) + a)))
            for h, readings in looks
            for a, reading in readings
            if reading < far
        ]
        middle_x = sum(x for x, _ in points) / len(points) if mean else 0
        middle_y = sum(y for _, y in points) / len(points) if mean else 0
        sxx = sum((x - middle_x) ** 2 for x, _ in points)
        syy = sum((y - middle_y) ** 2 for _, y in points)
        sxy = sum((x - middle_x) * (y - middle_y) for x, y in points)
        return angle(sxx, syy, sxy) if angle else degrees(atan2(2 * sxy, syy - sxx)) / 2 % 180

    return wall_direction


def by_slope(squares, _, products):
    """The line with the smallest distances straight up: none if the wall runs up the mat."""
    return 90 - degrees(atan(products / squares))


STRAIGHT_UP = (
    "distances are measured straight up from the line, and so a wall up the mat comes out wrong: "
    "measure them across the line, with half of atan2(2 * sxy, syy - sxx)"
)


def same_line(wanted, got):
    """Directions of lines: 0.1 and 179.9 are 0.2 apart; but an answer is from 0 to 180."""
    return (
        isinstance(got, int | float)
        and -0.01 <= got <= 180.01
        and abs((got - wanted + 90) % 180 - 90) < 0.05
    )


wall_direction = function(
    "wall_direction(looks)",
    line_by(),
    compare=same_line,
    leaves=True,
    mistakes=[
        mistake(
            "half of the angle that atan2() gives is the direction",
            line_by(angle=lambda a, b, c: degrees(atan2(2 * c, b - a)) % 180),
            1,
            where=calls("atan2"),
        ),
        (
            "the angle is from the x axis: here directions "
            "are from straight up, so it is syy - sxx",
            line_by(angle=lambda a, b, c: degrees(atan2(2 * c, a - b)) / 2 % 180),
            1,
        ),
        (STRAIGHT_UP, line_by(angle=by_slope), 1),
        (
            STRAIGHT_UP,
            line_by(angle=lambda a, b, c: 90 - degrees(atan2(c, a))),
            1,
        ),
        (
            "the heading is left out: a beam's direction is facing + angle",
            line_by(facing=lambda facing: 0),
            0,
        ),
        (
            "distances are from the middle of the points: take the mean of x and of y away first",
            line_by(mean=False),
            1,
        ),
        ("a reading of FAR or more is no point of the wall", line_by(far=1000), 0),
        (
            "a reading of exactly FAR is no point of the wall either: a hit is less than FAR",
            line_by(far=170.001),
            0,
        ),
        mistake(
            "degrees are wanted: math.atan2() gives radians",
            line_by(angle=lambda a, b, c: atan2(2 * c, b - a) / 2 % pi),
            1,
            where=calls("atan2"),
        ),
    ],
)


OTHER_FAR = 150
with_other_far = function(
    "wall_direction(looks)",
    line_by(far=OTHER_FAR),
    compare=same_line,
    leaves=True,
    mistakes=[
        mistake(
            "FAR was typed in as a number: use the name, because the check changes its value",
            line_by(),
            0,
            where=number(170),
        ),
    ],
)


def rate_by(
    turned=lambda first, second: (second - first + 90) % 180 - 90, per=lambda seconds: seconds
):
    """The drift, or a slip of it."""
    line = line_by()

    def drift_rate(first, second, seconds):
        return turned(line(first), line(second)) / per(seconds)

    return drift_rate


drift_rate = function(
    "drift_rate(first, second, seconds)",
    rate_by(),
    compare=near(0.002, "degrees/s"),
    leaves=True,
    mistakes=[
        (
            "the sign is turned round: it is the second direction minus the first",
            rate_by(lambda a, b: (a - b + 90) % 180 - 90),
            2,
        ),
        (
            "the two directions lie on either side of 0, where 180 comes next: "
            "bring the difference to between -90 and 90",
            rate_by(lambda a, b: b - a),
            2,
        ),
        mistake(
            "abs() takes the sign away: the drift may go either way, so keep it",
            rate_by(lambda a, b: abs(b - a)),
            2,
            where=calls("abs"),
        ),
        (
            "that is the angle, not the rate: divide by the seconds between",
            rate_by(per=lambda seconds: 1),
            2,
        ),
    ],
)


def seen(wall, cm, facing, chance=None, times=1, added=0.0):
    """Looks at a straight wall that runs in the direction `wall`, `cm` away, without drift."""
    looks = []
    for _ in range(times):
        readings = []
        for angle in FAN:
            slant = sin(radians(wall - facing - angle))
            reading = min(200.0, cm / abs(slant)) if abs(slant) > 0.01 else 200.0
            if chance and reading < 200:
                reading = min(200.0, reading + chance.normalvariate(0, 2))
            readings.append([angle, reading])
        looks.append((facing + added, readings))
    return looks


@check("A wall straight across", hint=0)
def across(task):
    task.call(wall_direction, seen(90, 60, 0), gives=90)
    task.call(wall_direction, seen(90, 60, 15), gives=90)


@check("A wall up the mat, one aslant", hint=1)
def aslant(task):
    task.call(wall_direction, seen(0, 80, 90))
    task.call(wall_direction, seen(30, 70, 110), gives=30)
    task.call(wall_direction, seen(150, 50, 250), gives=150)
    task.call(wall_direction, seen(30, 12, 110), gives=30)


@check("Noise, and readings of nothing", hint=0)
def noisy(task):
    for wall in (20, 75, 140):
        task.call(wall_direction, seen(wall, 115, wall + 62, task.random, times=4))


@check("A reading of exactly FAR, and another FAR", hint=0)
def at_far(task):
    beside = (60, [[-2.8125, 170.0], [2.8125, 170.0]])
    task.call(wall_direction, [*seen(90, 60, 0), beside], gives=90)
    task.set("FAR", OTHER_FAR)
    task.call(with_other_far, [*seen(90, 60, 0), (60, [[0, 150.0], [5.625, 160.0]])], gives=90)


@check("The drift between two looks", hint=2)
def between(task):
    task.call(drift_rate, seen(90, 60, 0), seen(90, 60, 0, added=8), 40, gives=0.2)
    task.call(drift_rate, seen(40, 60, 140), seen(40, 60, 140, added=-6), 30, gives=-0.2)


@check("A wall whose direction passes 0", hint=2)
def passes(task):
    task.call(drift_rate, seen(2, 60, 90), seen(2, 60, 90, added=-10), 50, gives=-0.2)
    task.call(drift_rate, seen(175, 60, 90), seen(175, 60, 90, added=12), 60, gives=0.2)


@check("The drift of a whole run", hint=2)
def whole(task):
    run = task.run("wall-ahead", seed=51, seconds=90)
    task.near(run.number_after("drift:"), run.drift, 0.05, "the drift in degrees/s", run=run)
