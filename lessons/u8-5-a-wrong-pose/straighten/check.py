"""corrected(looks, rate): dead reckoning with the drift taken out of heading and steps."""

from math import cos, hypot, radians, sin

from grader import calls, check, function, mistake


def by(
    turned=lambda angle, dx, dy: (
        dx * cos(angle) - dy * sin(angle),
        dy * cos(angle) + dx * sin(angle),
    ),
    steps=lambda rate, t: radians(rate * t),
    heading=lambda rate, t: -rate * t,
    places=False,
    begins=lambda look: look[1:3],
    since=lambda look: 0,
    at=lambda before, look: look[0],
):
    """The poses without the drift, or a slip of them."""

    def corrected(looks, rate):
        x, y = begins(looks[0])
        zero = since(looks[0])
        before, poses = (looks[0][0], *begins(looks[0])), []
        for look in looks:
            angle = steps(rate, at(before, look) - zero)
            dx, dy = turned(angle, look[1] - before[1], look[2] - before[2])
            x, y = turned(angle, look[1], look[2]) if places else (x + dx, y + dy)
            poses.append((x, y, look[3] + heading(rate, look[0] - zero)))
            before = look
        return poses

    return corrected


def about_the_start(looks, rate):
    (_, x, y), poses = looks[0][:3], []
    for look in looks:
        angle = radians(rate * look[0])
        dx, dy = look[1] - x, look[2] - y
        turned = dx * cos(angle) - dy * sin(angle), dy * cos(angle) + dx * sin(angle)
        poses.append((x + turned[0], y + turned[1], look[3] - rate * look[0]))
    return poses


def from_its_own_place(looks, rate):
    before, (x, y), poses = looks[0][1:3], looks[0][1:3], []
    for look in looks:
        angle = radians(rate * look[0])
        dx, dy = look[1] - before[0], look[2] - before[1]
        x, y = x + dx * cos(angle) - dy * sin(angle), y + dy * cos(angle) + dx * sin(angle)
        poses.append((x, y, look[3] - rate * look[0]))
        before = x, y
    return poses


def x_first(angle, dx, dy):
    dx = dx * cos(angle) - dy * sin(angle)
    return dx, dy * cos(angle) + dx * sin(angle)


def same_poses(wanted, got):
    """Places within 0.05 cm, headings within 0.05 degrees, in whatever turn they are counted."""
    try:
        return len(wanted) == len(got) and all(
            abs(a[0] - b[0]) < 0.05
            and abs(a[1] - b[1]) < 0.05
            and abs((a[2] - b[2] + 180) % 360 - 180) < 0.05
            for a, b in zip(wanted, got)
        )
    except (TypeError, IndexError):
        return False


corrected = function(
    "corrected(looks, rate)",
    by(),
    compare=same_poses,
    leaves=True,
    mistakes=[
        (
            "only the heading is corrected: each step was added in a wrong direction, too",
            by(steps=lambda rate, t: 0),
            1,
        ),
        (
            "the steps are corrected, the heading is not: it is rate * t too large",
            by(heading=lambda rate, t: 0),
            0,
        ),
        (
            "the drift is added once more: it has to be taken away",
            by(steps=lambda rate, t: -radians(rate * t), heading=lambda rate, t: rate * t),
            0,
        ),
        (
            "the steps are turned the wrong way: a belief that has "
            "drifted clockwise is turned back, counter-clockwise",
            by(steps=lambda rate, t: -radians(rate * t)),
            2,
        ),
        mistake(
            "degrees look taken for radians: math.sin() and math.cos() want math.radians()",
            by(steps=lambda rate, t: rate * t),
            2,
            where=calls("sin", "cos", "exp", "rect"),
        ),
        (
            "the places are turned about the start as they are: "
            "each was added up of steps that had drifted less",
            by(places=True),
            1,
        ),
        (
            "the drift grows with time: at the time t it is rate * t",
            by(steps=lambda rate, t: radians(rate), heading=lambda rate, t: -rate),
            0,
        ),
        (
            "all of the route is turned by one angle: turn each step by the drift at its own time",
            about_the_start,
            1,
        ),
        (
            "the route begins at (0, 0): its first place is that of the first look",
            by(begins=lambda look: (0, 0)),
            1,
        ),
        (
            "the drift is counted from the first look: at the time t it is rate * t, "
            "whenever the first look is",
            by(since=lambda look: look[0]),
            0,
        ),
        (
            "each step is turned by the drift at its beginning: take the time of the look "
            "in which it ends",
            by(at=lambda before, look: before[0]),
            2,
        ),
        (
            "a step is the difference of two looks as they are: your own corrected place is not "
            "where it began",
            from_its_own_place,
            1,
        ),
        ("x is changed before y is worked out: y needs the old dx", by(turned=x_first), 2),
    ],
)


@check("A robot that only turns", hint=0)
def turning(task):
    looks = [(0.0, 0.0, 0.0, 10.0), (10.0, 0.0, 0.0, 12.0), (50.0, 0.0, 0.0, 20.0)]
    task.call(corrected, looks, 0.2, gives=[(0, 0, 10), (0, 0, 10), (0, 0, 10)])


@check("Two steps, the second after a long wait", hint=1)
def two_steps(task):
    # After 100 s the belief has drifted by 30 degrees: a step straight up was believed to go right.
    looks = [(0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 20.0, 0.0), (100.0, 5.0, 28.66, 30.0)]
    task.call(corrected, looks, 0.3)
    task.call(corrected, looks, -0.3)


@check("A first look away from the start, and not at the time 0", hint=0)
def later(task):
    # After 50 s the belief has drifted by 10 degrees, after 100 s by 20.
    looks = [(50.0, 40.0, -20.0, 100.0), (100.0, 40.0, -20.0, 110.0), (100.0, 60.0, -5.0, 110.0)]
    task.call(corrected, looks[:2], 0.2, gives=[(40, -20, 90), (40, -20, 90)])
    task.call(corrected, looks, 0.2)


@check("A way round corners, and one that begins elsewhere", hint=2)
def way(task):
    for rate in (0.22, -0.17):
        t, x, y, facing = 0.0, 3.0, -7.0, 80.0
        looks = []
        for _ in range(12):
            looks.append((t, x, y, facing, []))
            t += task.random.uniform(3, 9)
            x += task.random.uniform(-15, 15)
            y += task.random.uniform(-15, 15)
            facing = (facing + task.random.uniform(-60, 60)) % 360
        task.call(corrected, looks, rate)


@check("The way round the ring", hint=2)
def ring(task):
    run = task.run("hall", seed=61, seconds=90)
    way, looks = run.layer("corrected"), len(run.layer("as it believes"))
    task.expect(
        len(way) == looks,
        expected=f"a place on the corrected way for each of the {looks} looks",
        got=f"{len(way)} places",
        run=run,
    )
    true = [run.pose_at(0.2 * look) for look in range(len(way))]
    worst = max(hypot(x - a, y - b) for (x, y), (a, b, _) in zip(way, true))
    task.expect(
        worst < 4,
        expected="the corrected way within 4 cm of the true one all along",
        got=f"{worst:.1f} cm away at its worst",
        run=run,
    )
