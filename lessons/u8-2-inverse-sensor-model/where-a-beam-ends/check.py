"""end_of_beam(x, y, angle, reading): the point where a beam ended."""

from math import cos, degrees, radians, sin

from grader import check, function, near
from mapping.beam import end_of_beam as right_end

end_of_beam = function(
    "end_of_beam(x, y, angle, reading)",
    right_end,
    compare=near(0.01, "cm"),
    mistakes=[
        (
            "sine and cosine look swapped: an angle is clockwise from up the mat, so x goes by "
            "sine and y by cosine",
            lambda x, y, angle, reading: (
                x + reading * cos(radians(angle)),
                y + reading * sin(radians(angle)),
            ),
            0,
        ),
        (
            "degrees look taken for radians: turn the angle into radians before math.sin() and "
            "math.cos()",
            lambda x, y, angle, reading: (x + reading * sin(angle), y + reading * cos(angle)),
            1,
        ),
        (
            "y was taken to grow downwards: on the mat y grows upwards, so add",
            lambda x, y, angle, reading: right_end(x, y, 180 - angle, reading),
            0,
        ),
        (
            "where the beam began was left out: add x and y",
            lambda x, y, angle, reading: right_end(0, 0, angle, reading),
            2,
        ),
        (
            "the angle was taken anticlockwise: a positive angle points to the right, so add to x",
            lambda x, y, angle, reading: right_end(x, y, -angle, reading),
            0,
        ),
        (
            "math.degrees() goes the wrong way: the angle is in degrees already, and "
            "math.radians() makes radians of it",
            lambda x, y, angle, reading: right_end(x, y, degrees(degrees(angle)), reading),
            1,
        ),
        (
            "the reading was left out: multiply the sine and the cosine by it",
            lambda x, y, angle, reading: right_end(x, y, angle, 1),
            2,
        ),
    ],
)


@check("A beam straight up the mat", hint=0)
def up(task):
    task.call(end_of_beam, 100, 50, 0, 30, gives=(100, 80))


@check("A beam to the right", hint=0)
def to_the_right(task):
    task.call(end_of_beam, 100, 50, 90, 30, gives=(130, 50))


@check("Down and to the left", hint=0)
def down_and_left(task):
    task.call(end_of_beam, 100, 50, 180, 30, gives=(100, 20))
    task.call(end_of_beam, 100, 50, 270, 30, gives=(70, 50))


@check("30 degrees to the right of straight up", hint=1)
def slanting(task):
    task.call(end_of_beam, 20, 10, 30, 100, gives=(70, 96.6025))


@check("Beams in all directions", hint=2)
def all_round(task):
    for _ in range(20):
        x, y = (round(task.random.uniform(10, 190), 1) for _ in range(2))
        angle = round(task.random.uniform(-20, 380), 1)
        task.call(end_of_beam, x, y, angle, round(task.random.uniform(5, 170), 1))
