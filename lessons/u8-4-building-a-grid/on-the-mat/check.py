"""The trail and the dots where beams ended, held against the run's own scans."""

from math import cos, hypot, radians, sin

from grader import calls, check, lacks, mistake, operator


def pose(run, scan):
    return scan.x, scan.y, scan.heading


def trail(run, seen_as=pose):
    return [seen_as(run, scan)[:2] for scan in run.scans]


def walls(
    run,
    seen_as=pose,
    turned=radians,
    far=170,
    which=slice(None),
    from_robot=1,
    up=1,
    fan=1,
    way_of=None,
    kept=lambda x, y: True,
):
    dots = []
    for scan in run.scans:
        x, y, facing = seen_as(run, scan)
        found = []
        for angle, reading in scan.beams:
            if reading < far:
                way = turned(facing + fan * angle) if way_of is None else way_of(facing, angle)
                end = (
                    from_robot * x + reading * sin(way),
                    from_robot * y + up * reading * cos(way),
                )
                if kept(*end):
                    found.append(end)
        dots += found[which]
    return dots


def alike(dots, others):
    return len(dots) == len(others) and all(
        hypot(a[0] - b[0], a[1] - b[1]) < 0.1 for a, b in zip(dots, others)
    )


def slip(said, hint, **how):
    """A slip that shows in the dots: how they would come out."""
    return (said, lambda run: alike(run.layer("walls"), walls(run, **how)), hint)


SLIPS = [
    mistake(
        "odometry() is what the robot believes, and it drifts: position() says where it is",
        lambda run: not alike(run.layer("trail"), trail(run)),
        0,
        where=(calls("odometry"), lacks(calls("position"))),
    ),
    (
        "no time passes, so the robot never moves: the loop needs its wait(0.1)",
        lambda run: run.seconds < 1,
        2,
    ),
    slip(
        "position() is from where the robot started: add START to get the place on the mat",
        0,
        seen_as=lambda run, scan: (scan.x - run.start.x, scan.y - run.start.y, scan.heading),
    ),
    slip(
        "the pose is that of the start, not of now: ask position() each time",
        0,
        seen_as=lambda run, scan: (run.start.x, run.start.y, scan.heading),
    ),
    slip(
        "the pose is that of the start, not of now: ask position() and heading() each time",
        0,
        seen_as=lambda run, scan: (run.start.x, run.start.y, run.start.heading),
    ),
    slip(
        "heading() was added twice: facing is the heading already",
        1,
        seen_as=lambda run, scan: (scan.x, scan.y, 2 * scan.heading),
    ),
    slip(
        "the beams start at the robot: add its x and y to where each of them ends",
        1,
        from_robot=0,
    ),
    slip("only the first beam of each scan got a dot: go through all eight", 2, which=slice(1)),
    slip(
        "only the last beam of each scan got a dot: append() belongs inside the loop",
        2,
        which=slice(-1, None),
    ),
    slip(
        "y was taken to grow downwards: on the mat y grows upwards; look at the signs of the angle "
        "and of y",
        2,
        up=-1,
    ),
    slip("the angle was subtracted: angles are positive to the right, so add it", 1, fan=-1),
    slip(
        "the heading is left out: a beam's direction is heading() + angle",
        1,
        seen_as=lambda run, scan: (scan.x, scan.y, 0),
    ),
    slip(
        "sine and cosine are the wrong way round: x goes by sine and y by cosine",
        2,
        turned=lambda angle: radians(90 - angle),
    ),
    slip(
        "degrees were taken for radians: math.sin() and math.cos() want math.radians()",
        2,
        turned=lambda angle: angle,
    ),
    slip("the maximum was taken for a wall: a reading of FAR or more gets no dot", 2, far=1000),
    slip(
        "math.radians() got only one of the two angles: turn facing + angle into radians",
        1,
        way_of=lambda facing, angle: radians(facing) + angle,
    ),
    slip(
        "math.radians() got only one of the two angles: turn facing + angle into radians",
        1,
        way_of=lambda facing, angle: facing + radians(angle),
    ),
    mistake(
        "a reading of exactly FAR has found nothing either: a dot is for less than FAR",
        lambda run: alike(run.layer("walls"), walls(run, far=170.000001)),
        2,
        where=operator("<=", ">", ">="),
    ),
    slip(
        "dots a little off the mat are left out: noise puts some there, and each hit gets its dot",
        2,
        kept=lambda x, y: 0 <= x < 200 and 0 <= y < 200,
    ),
    (
        "the trail gets a point for every beam: one for each look is enough, outside the loop",
        lambda run: alike(
            run.layer("trail"), [place for place in trail(run) for _ in run.scans[0].beams]
        ),
        2,
    ),
    slip(
        "x and y are the wrong way round: position() gives x first",
        0,
        seen_as=lambda run, scan: (
            run.start.x + scan.y - run.start.y,
            run.start.y + scan.x - run.start.x,
            scan.heading,
        ),
    ),
]


def dots_fit(task, world, seed):
    run = task.run(world, seed=seed, seconds=30, mistakes=SLIPS)
    run.scanned(at_least=80).visits(lambda x, y: x > 80, "the end of the bend")
    for name, wanted, hint in (("trail", trail(run), 0), ("walls", walls(run), 1)):
        dots = run.layer(name)
        task.expect(
            len(dots) == len(wanted),
            expected=f"{len(wanted)} points in the layer {name!r}",
            got=f"{len(dots)}",
            run=run,
            hint=2,  # the loop and its condition
        )
        for dot, right in zip(dots, wanted):
            task.expect(
                hypot(dot[0] - right[0], dot[1] - right[1]) < 0.1,
                expected=f"in {name!r}, a point at ({right[0]:.1f}, {right[1]:.1f})",
                got=f"({dot[0]:.1f}, {dot[1]:.1f})",
                run=run,
                hint=hint,
            )


@check("The bend of the page, with other noise", hint=0)
def same_bend(task):
    dots_fit(task, "bend", 21)


@check("Another room", hint=1)
def screens(task):
    dots_fit(task, "bend-with-screens", 22)
