# style: the second half of the run against a map of the first half
def near_cells(cells):
    return {(c + i, r + j) for c, r in cells for i in (-1, 0, 1) for j in (-1, 0, 1)}


def find_rate(looks):
    """How fast the believed heading drifts, in degrees/s."""
    half = len(looks) // 2

    def strays(rate):
        """Cells with a hit in one half of the run only."""
        poses = corrected(looks, rate)
        first = walls_of(poses[:half], looks[:half])
        second = walls_of(poses[half:], looks[half:])
        return len(first ^ second) + len(second - near_cells(first))

    return min((i * 0.01 for i in range(-42, 43)), key=strays)


def corrected(looks, rate):
    """The poses of the looks without the drift: (x, y, facing)."""
    poses = []
    x, y = looks[0][1:3]
    before = looks[0]
    for look in looks:
        turned = math.radians(rate * look[0])
        dx, dy = look[1] - before[1], look[2] - before[2]
        x += dx * math.cos(turned) - dy * math.sin(turned)
        y += dy * math.cos(turned) + dx * math.sin(turned)
        poses.append((x, y, look[3] - rate * look[0]))
        before = look
    return poses
