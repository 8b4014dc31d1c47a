"""wall_direction(looks) and drift_rate(first, second, seconds), and the drift of a whole run."""

from math import atan, atan2, cos, degrees, pi, radians, sin

from grader import calls, check, function, mistake, near, number

FAN = [-19.6875 + 5.625 * i for i in range(8)]


def hits(looks, far=170):
    """Where the hits are, seen from the robot."""
    return [
        (reading * sin(radians(facing + angle)), reading * cos(radians(facing + angle)))
        for facing, readings in looks
        for angle, reading in readings
        if reading < far
    ]


def line_by(facing=None, far=170, mean=True, angle=None):
    """The direction of the line through all hits, or a slip of it."""

    def wall_direction(looks):
        if facing:  # the same for all looks
            looks = [(facing([h for h, _ in looks]), readings) for _, readings in looks]
        points = hits(looks, far)
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


def through(two):
    """The direction of the line through two of the hits."""

    def wall_direction(looks):
        (x0, y0), (x1, y1) = two(hits(looks))
        return degrees(atan2(x1 - x0, y1 - y0)) % 180

    return wall_direction


def mean_of_lines(looks):
    """A line for each look, and the mean of their directions."""
    return sum(line_by()([look]) for look in looks) / len(looks)


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
            STRAIGHT_UP,
            line_by(angle=lambda a, b, c: by_slope(a, b, c) if a > 1e-6 else 0),
            1,
        ),
        (
            "first halve the angle, then bring it to between 0 and 180 with % 180",
            line_by(angle=lambda a, b, c: degrees(atan2(2 * c, b - a)) % 180 / 2),
            1,
        ),
        *(
            ("only two of the hits count: the line goes through all of them", through(two), 1)
            for two in (
                lambda points: (points[0], points[-1]),
                lambda points: (min(points), max(points)),
            )
        ),
        (
            "that is the mean of a line for each look: gather the hits of all looks, "
            "and find one line through them",
            mean_of_lines,
            0,
        ),
        (
            "the heading is left out: a beam's direction is facing + angle",
            line_by(facing=lambda facings: 0),
            0,
        ),
        *(
            ("one facing is used for all looks, but each look has its own", line_by(facing=one), 0)
            for one in (
                lambda facings: facings[0],
                lambda facings: facings[-1],
                lambda facings: sum(facings) / len(facings),
            )
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
        *(
            (
                "the difference is put right one way only: it may be below -90 as well as above 90",
                rate_by(turned),
                2,
            )
            for turned in (
                lambda a, b: b - a - 180 if b - a > 90 else b - a,
                lambda a, b: b - a + 180 if b - a < -90 else b - a,
            )
        ),
        mistake(
            "abs() takes the sign away: the drift may go either way, so keep it",
            rate_by(lambda a, b: abs(b - a)),
            2,
            where=calls("abs"),
        ),
        (
            "the sign is lost: a wall that seems to turn left has a drift below 0",
            rate_by(lambda a, b: abs((b - a + 90) % 180 - 90)),
            2,
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


@check("Looks that face different ways", hint=0)
def facings(task):
    task.call(wall_direction, [*seen(40, 60, 130), *seen(40, 60, 165)], gives=40)
    task.call(wall_direction, [*seen(100, 50, 20), *seen(100, 50, 0), *seen(100, 50, 355)])


@check("A wall up the mat, one aslant", hint=1)
def aslant(task):
    task.call(wall_direction, seen(0, 80, 90))
    task.call(wall_direction, seen(30, 70, 110), gives=30)
    task.call(wall_direction, seen(150, 50, 250), gives=150)
    task.call(wall_direction, seen(30, 12, 110), gives=30)


@check("Noise, and readings of nothing", hint=1)
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
    task.call(drift_rate, seen(40, 60, 140), seen(40, 60, 140, added=-6), 40, gives=-0.15)


@check("A wall whose direction passes 0", hint=2)
def passes(task):
    task.call(drift_rate, seen(2, 60, 90), seen(2, 60, 90, added=-10), 40, gives=-0.25)
    task.call(drift_rate, seen(175, 60, 90), seen(175, 60, 90, added=12), 40, gives=0.3)


@check("The drift of a whole run", hint=2)
def whole(task):
    run = task.run("wall-ahead", seed=51, seconds=90)
    task.near(run.number_after("drift:"), run.drift, 0.05, "the drift in degrees/s", run=run)
