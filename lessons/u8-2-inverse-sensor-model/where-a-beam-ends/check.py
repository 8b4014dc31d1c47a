"""end_of_beam(x, y, angle, reading): the point where a beam ended.

The robot faces 20 degrees meanwhile, so that a heading which is added to the angle shows.
"""

from math import cos, degrees, pi, radians, sin

from grader import calls, check, code, function, mistake, near, number, operator, reads
from mapping.beam import end_of_beam as right_end


def by(along_x, along_y):
    """What a mistake answers that goes so far along x and y for each cm of the reading."""
    return lambda x, y, angle, reading: (
        x + reading * along_x(angle),
        y + reading * along_y(angle),
    )


def sine(angle):
    return sin(radians(angle))


def cosine(angle):
    return cos(radians(angle))


def turned(change):
    """What a mistake answers that changes the angle."""
    return lambda x, y, angle, reading: right_end(x, y, change(angle), reading)


def rounded(change):
    """What a mistake answers that changes both numbers of the right point."""
    return lambda *asked: tuple(map(change, right_end(*asked)))


ROUNDED = "the point was rounded: return x and y with all their decimals"
TURNED = (
    "heading() was added: the angle is the direction on the mat already, so use it as it is given"
)

end_of_beam = function(
    "end_of_beam(x, y, angle, reading)",
    right_end,
    compare=near(1e-6, "cm"),
    mistakes=[
        mistake(
            "90 - angle goes with cosine for x and sine for y: leave one of the two changes out",
            by(cosine, sine),
            0,
            where=code("90 - angle"),
        ),
        mistake(
            "sine and cosine are the wrong way round: the angle is clockwise from straight up the "
            "mat, so x goes by sine and y by cosine",
            by(cosine, sine),
            0,
            where=(calls("sin"), calls("cos")),
        ),
        mistake(
            "degrees were taken for radians: turn the angle into radians before math.sin() and "
            "math.cos()",
            by(sin, cos),
            1,
            where=calls("sin", "cos", "exp", "rect"),
        ),
        mistake(
            "only one of the two got radians: math.sin() and math.cos() both want them",
            by(sine, cos),
            1,
            where=(calls("sin"), calls("cos")),
        ),
        mistake(
            "only one of the two got radians: math.sin() and math.cos() both want them",
            by(sin, cosine),
            1,
            where=(calls("sin"), calls("cos")),
        ),
        mistake(
            "x and y both go by sine: y goes by cosine",
            by(sine, sine),
            0,
            where=calls("sin"),
        ),
        mistake(
            "x and y both go by cosine: x goes by sine",
            by(cosine, cosine),
            0,
            where=calls("cos"),
        ),
        (
            "y was taken to grow downwards: on the mat y grows upwards; look at the signs of the "
            "angle and of y",
            lambda x, y, angle, reading: right_end(x, y, 180 - angle, reading),
            0,
        ),
        (
            "the beam goes backwards: look at the signs of x and y, and at what is added to the "
            "angle",
            lambda x, y, angle, reading: right_end(x, y, angle + 180, reading),
            2,
        ),
        (
            "where the beam began was left out: add x and y",
            lambda x, y, angle, reading: right_end(0, 0, angle, reading),
            2,
        ),
        mistake(
            "the beam begins at START here: it begins at the x and y that the function is given",
            lambda x, y, angle, reading: right_end(100, 40, angle, reading),
            2,
            where=reads("START"),
        ),
        mistake(
            "START was added: x and y count from the corner of the mat already",
            lambda x, y, angle, reading: right_end(x + 100, y + 40, angle, reading),
            2,
            where=reads("START"),
        ),
        (
            "the angle was taken anticlockwise: a positive angle points to the right; look at the "
            "signs of the angle and of x",
            lambda x, y, angle, reading: right_end(x, y, -angle, reading),
            0,
        ),
        mistake(
            "math.degrees() goes the wrong way: the angle is in degrees already, and "
            "math.radians() makes radians of it",
            lambda x, y, angle, reading: right_end(x, y, degrees(degrees(angle)), reading),
            1,
            where=calls("degrees", "rad2deg"),
        ),
        (
            "the reading was left out: multiply the sine and the cosine by it",
            lambda x, y, angle, reading: right_end(x, y, angle, 1),
            2,
        ),
        (
            "the sum was multiplied: only the reading is to be multiplied by the sine or the "
            "cosine, so leave out the brackets",
            lambda x, y, angle, reading: (
                (x + reading) * sine(angle),
                (y + reading) * cosine(angle),
            ),
            2,
        ),
        (
            "the answer is (y, x): x comes first",
            lambda *asked: right_end(*asked)[::-1],
            0,
        ),
        mistake(
            TURNED,
            lambda x, y, angle, reading: right_end(x, y, angle + 20, reading),
            0,
            where=calls("heading"),
        ),
        mistake(
            TURNED,
            lambda x, y, angle, reading: right_end(x, y, angle + 70, reading),
            0,
            where=calls("heading"),
        ),
        (ROUNDED, rounded(round), 2),
        (ROUNDED, rounded(int), 2),
        (ROUNDED, rounded(lambda value: round(value, 1)), 2),
        (ROUNDED, rounded(lambda value: round(value, 2)), 2),
        (ROUNDED, rounded(lambda value: round(value, 3)), 2),
        mistake(
            "the sign of the angle was lost: -30 is 30 degrees to the left of straight up",
            turned(abs),
            0,
            where=calls("abs", "fabs"),
        ),
        mistake(
            "a full turn is 360 degrees, not 180; sine and cosine take any angle as it is",
            turned(lambda angle: angle % 180),
            0,
            where=(operator("%"), number(180)),
        ),
        mistake(
            "a full turn is 360 degrees, not 180; sine and cosine take any angle as it is",
            turned(lambda angle: angle + 180 if angle < 0 else angle),
            0,
            where=number(180),
        ),
        mistake(
            "beyond 180 the angle was folded back to the right: sine and cosine take any angle as "
            "it is",
            turned(lambda angle: 360 - angle if angle > 180 else angle),
            0,
            where=number(180),
        ),
        mistake(
            "the angle was cut to whole degrees: use it as it is given",
            turned(int),
            1,
            where=calls("int"),
        ),
        mistake(
            "pi is typed in with too few digits: use math.pi or math.radians()",
            turned(lambda angle: angle * 3.14 / pi),
            1,
            where=number(3.14),
        ),
        mistake(
            "pi is typed in with too few digits: use math.pi or math.radians()",
            turned(lambda angle: angle * 3.1416 / pi),
            1,
            where=number(3.1416),
        ),
        (
            "y was left out where the beam began: add it to end_y",
            lambda x, y, angle, reading: (
                x + reading * sine(angle),
                reading * cosine(angle),
            ),
            2,
        ),
        (
            "x was left out where the beam began: add it to end_x",
            lambda x, y, angle, reading: (
                reading * sine(angle),
                y + reading * cosine(angle),
            ),
            2,
        ),
        (
            "y goes on from where x ended: the second sum begins with y",
            lambda x, y, angle, reading: (
                x + reading * sine(angle),
                x + reading * sine(angle) + reading * cosine(angle),
            ),
            2,
        ),
        (
            "a cell was taken off the reading: the beam ended at the full reading",
            lambda x, y, angle, reading: right_end(x, y, angle, reading - 5),
            2,
        ),
    ],
)


def ask(task, *asked, **gives):
    task.call(end_of_beam, *asked, **gives, world="wall-askew")


@check("A beam straight up the mat", hint=0)
def up(task):
    ask(task, 100, 50, 0, 30, gives=(100, 80))


@check("A beam to the right", hint=0)
def to_the_right(task):
    ask(task, 100, 50, 90, 30, gives=(130, 50))


@check("Down and to the left", hint=0)
def down_and_left(task):
    ask(task, 100, 50, 180, 30, gives=(100, 20))
    ask(task, 100, 50, 270, 30, gives=(70, 50))


@check("30 degrees to the right of straight up", hint=1)
def slanting(task):
    ask(task, 20, 10, 30, 100, gives=(70, 96.602540378))


@check("Angles below 0 and above 360", hint=1)
def any_angle(task):
    for angle in (-30, -150, -400, 400, 760):
        ask(task, 100, 50, angle, 40)


@check("Beams in all directions", hint=2)
def all_round(task):
    for _ in range(20):
        x, y = (round(task.random.uniform(10, 190), 1) for _ in range(2))
        angle = round(task.random.uniform(-20, 380), 1)
        ask(task, x, y, angle, round(task.random.uniform(5, 170), 1))
