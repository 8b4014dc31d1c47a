# style: named tuples, the step's length and direction, a while loop
from collections import namedtuple

Pose = namedtuple("Pose", "x y facing")


def corrected(looks, rate):
    start = looks[0]
    poses = [Pose(start[1], start[2], start[3] - start[0] * rate)]
    i = 1
    while i < len(looks):
        t, x, y, facing, *_ = looks[i]
        _, old_x, old_y, *_ = looks[i - 1]
        length = math.dist((x, y), (old_x, old_y))
        direction = math.atan2(y - old_y, x - old_x) + math.radians(t * rate)
        last = poses[-1]
        poses.append(
            Pose(
                last.x + length * math.cos(direction),
                last.y + length * math.sin(direction),
                facing - t * rate,
            )
        )
        i += 1
    return poses
