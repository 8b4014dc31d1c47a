"""speeds(dx, dy, facing): which way to drive, seen from a robot that faces any way."""

from math import atan2, cos, degrees, hypot, radians, sin

from grader import calls, check, function, mistake, near


def by(facing_in=lambda facing: radians(facing), way=atan2, scale=lambda dx, dy: 100.0):
    """What is right, or a slip of it."""

    def speeds(dx, dy, facing):
        if dx == 0 and dy == 0:
            return (0, 0)
        off = way(dx, dy) - facing_in(facing)
        return (scale(dx, dy) * cos(off), scale(dx, dy) * sin(off))

    return speeds


def swapped(dx, dy, facing):
    return tuple(reversed(by()(dx, dy, facing)))


def still_going(dx, dy, facing):
    return by()(dx, dy, facing) if dx or dy else (100, 0)


def in_degrees(dx, dy, facing):
    off = degrees(atan2(dx, dy)) - facing
    return (100 * cos(off), 100 * sin(off)) if dx or dy else (0, 0)


speeds = function(
    "speeds(dx, dy, facing)",
    by(),
    compare=near(0.1, "per cent"),
    mistakes=[
        mistake(
            "sine and cosine look swapped: ahead goes by the cosine of the angle between the "
            "robot's heading and the way, to the right by its sine",
            swapped,
            1,
            where=calls("sin", "cos"),
        ),
        (
            "the heading is left out: what is ahead depends on the way the robot faces",
            by(lambda facing: 0.0),
            0,
        ),
        (
            "the heading looks added: take it away from the direction of the way",
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
            "degrees look taken for radians: the heading is in degrees, math works in radians",
            by(lambda facing: facing),
            2,
            where=calls("sin", "cos", "exp", "rect"),
        ),
        (
            "the speed depends on how far it is: make it 100 per cent altogether",
            by(scale=hypot),
            2,
        ),
        mistake(
            "an angle in degrees went into math.sin() and math.cos(): they want radians",
            in_degrees,
            2,
            where=calls("sin", "cos"),
        ),
        (
            "near the target the robot slows down: it drives at 100 per cent however near it is",
            by(scale=lambda dx, dy: min(100, 10 * hypot(dx, dy))),
            2,
        ),
        (
            "a target less than 1 cm away counts as reached: stop only if dx and dy are both 0",
            lambda dx, dy, facing: by()(dx, dy, facing) if hypot(dx, dy) >= 1 else (0, 0),
            2,
        ),
        ("at the target the robot drives on: there both are 0", still_going, 2),
    ],
)


@check("It faces the target", hint=0)
def ahead(task):
    task.call(speeds, 0, 50, 0, gives=(100, 0))
    task.call(speeds, 30, 0, 90, gives=(100, 0))


@check("The target is to one side", hint=0)
def beside(task):
    task.call(speeds, 40, 0, 0, gives=(0, 100))
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
