"""speeds(dx, dy, facing): which way to drive, seen from a robot that faces any way."""

from math import asin, atan, atan2, cos, degrees, hypot, pi, radians, sin

from grader import calls, check, function, mistake, near


def by(facing_in=radians, way=atan2, scale=lambda dx, dy: 100.0):
    """What is right, or a slip of it."""

    def speeds(dx, dy, facing):
        if dx == 0 and dy == 0:
            return (0, 0)
        off = way(dx, dy) - facing_in(facing)
        return (scale(dx, dy) * cos(off), scale(dx, dy) * sin(off))

    return speeds


def then(change):
    """What is right, changed afterwards."""
    return lambda dx, dy, facing: tuple(change(*by()(dx, dy, facing)))


def stopped_where(reached):
    """It stops too early."""
    return lambda dx, dy, facing: (0, 0) if reached(dx, dy) else by()(dx, dy, facing)


def still_going(dx, dy, facing):
    return by()(dx, dy, facing) if dx or dy else (100, 0)


def zero_forgotten(dx, dy, facing):
    off = atan2(dx, dy) - radians(facing)
    return (100 * cos(off), 100 * sin(off))


def scaled_by(size):
    """The two numbers divided by something other than how long they are together."""

    def change(ahead, right):
        of = size(abs(ahead), abs(right)) / 100 or 1
        return ahead / of, right / of

    return then(change)


def in_degrees(dx, dy, facing):
    off = degrees(atan2(dx, dy)) - facing
    return (100 * cos(off), 100 * sin(off)) if dx or dy else (0, 0)


def quotient(of_dx, half_turn, level=None):
    """A direction by atan(dx / dy), or by 90 degrees less atan(dy / dx).

    half_turn  whether it is added where the number below the line is under 0
    level      what is taken where that number is 0 (in degrees); None: it is divided by
    """

    def way(dx, dy):
        over, under = (dx, dy) if of_dx else (dy, dx)
        if under == 0 and level is not None:
            return radians(level)
        found = atan(over / under) if of_dx else pi / 2 - atan(over / under)
        return found + (pi if half_turn and under < 0 else 0)

    return way


QUOTIENTS = [
    quotient(of_dx, half_turn, level)
    for of_dx, straight in ((True, 90), (False, 0))
    for half_turn in (False, True)
    for level in (None, straight)
]

speeds = function(
    "speeds(dx, dy, facing)",
    by(),
    compare=near(0.1, "per cent"),
    mistakes=[
        mistake(
            "sine and cosine look swapped, or the two numbers are in the wrong order: what is "
            "ahead comes first and goes by the cosine of the angle between the robot's heading "
            "and the direction of the target",
            then(lambda ahead, right: (right, ahead)),
            1,
            where=calls("sin", "cos"),
        ),
        (
            "the second number has the wrong sign: to the right is above 0, to the left below",
            then(lambda ahead, right: (ahead, -right)),
            1,
        ),
        (
            "the second number is never below 0: it has to be for a target to the left",
            then(lambda ahead, right: (ahead, abs(right))),
            1,
        ),
        (
            "the first number is never below 0: it has to be for a target behind the robot",
            then(lambda ahead, right: (abs(ahead), right)),
            1,
        ),
        (
            "the heading is left out: what is ahead depends on the way the robot faces",
            by(lambda facing: 0.0),
            0,
        ),
        (
            "the heading looks added: take it away from the direction of the target",
            by(lambda facing: -radians(facing)),
            1,
        ),
        mistake(
            "math.atan2 has its two numbers the wrong way round: a heading is atan2(dx, dy)",
            by(way=lambda dx, dy: atan2(dy, dx)),
            2,
            where=calls("atan2"),
        ),
        mistake(
            "math.asin can't tell what is up the mat from what is down: use math.atan2(dx, dy)",
            by(way=lambda dx, dy: asin(dx / hypot(dx, dy))),
            2,
            where=calls("asin"),
        ),
        *[
            mistake(
                "math.atan of a quotient can't tell all directions, and nothing can be divided "
                "by 0: use math.atan2(dx, dy)",
                by(way=way),
                2,
                where=calls("atan"),
            )
            for way in QUOTIENTS
        ],
        mistake(
            "it looks as if degrees were taken for radians: the heading is in degrees, math "
            "works in radians",
            by(lambda facing: facing),
            2,
            where=calls("sin", "cos", "exp", "rect"),
        ),
        (
            "the speed depends on how far it is: make it 100 per cent altogether",
            by(scale=hypot),
            2,
        ),
        (
            "the larger of the two numbers is always 100: the robot is to move at 100 per cent "
            "altogether, so it is their math.hypot() that has to be 100",
            scaled_by(max),
            2,
        ),
        (
            "the two numbers always add up to 100: the robot is to move at 100 per cent "
            "altogether, so it is their math.hypot() that has to be 100",
            scaled_by(lambda ahead, right: ahead + right),
            2,
        ),
        mistake(
            "an angle in degrees went into math.sin() and math.cos(): they want radians",
            in_degrees,
            2,
            where=calls("sin", "cos"),
        ),
        (
            "near the target the robot slows down: it should drive at 100 per cent however near "
            "it is",
            by(scale=lambda dx, dy: min(100, 10 * hypot(dx, dy))),
            2,
        ),
        *[
            (
                "a target that is near counts as reached: stop only if dx and dy are both 0",
                stopped_where(lambda dx, dy, limit=limit: hypot(dx, dy) < limit),
                2,
            )
            for limit in (1, 4.5, 5.5)
        ],
        (
            "it stops if one of dx and dy is 0: stop only if both are",
            stopped_where(lambda dx, dy: dx == 0 or dy == 0),
            2,
        ),
        ("at the target the robot drives on: there both are 0", still_going, 2),
        ("at the target the robot drives on: there both are 0", zero_forgotten, 2),
        mistake(
            "the numbers were rounded: return them with their decimals",
            then(lambda ahead, right: (round(ahead), round(right))),
            2,
            where=calls("round"),
        ),
    ],
)


@check("It faces the target", hint=0)
def ahead(task):
    task.call(speeds, 0, 50, 0, gives=(100, 0))
    task.call(speeds, 30, 0, 90, gives=(100, 0))


@check("The target is to one side", hint=0)
def beside(task):
    task.call(speeds, 40, 0, 0, gives=(0, 100))
    task.call(speeds, -40, 0, 0, gives=(0, -100))
    task.call(speeds, 0, 25, 90, gives=(0, -100))
    task.call(speeds, 0, -25, 0, gives=(-100, 0))


@check("Any way", hint=1)
def any_way(task):
    for _ in range(20):
        dx, dy = task.random.uniform(-90, 90), task.random.uniform(-90, 90)
        task.call(speeds, dx, dy, task.random.uniform(0, 360))


@check("The target is near", hint=2)
def near_by(task):
    task.call(speeds, 0, 4, 90, gives=(0, -100))
    task.call(speeds, -3, 4, 0, gives=(80, -60))
    task.call(speeds, 0.5, 0, 90, gives=(100, 0))


@check("It is there", hint=2)
def there(task):
    task.call(speeds, 0, 0, 130, gives=(0, 0))
