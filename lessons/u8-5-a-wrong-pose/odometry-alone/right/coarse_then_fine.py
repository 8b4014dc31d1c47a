# style: first coarse, then fine, round the best so far
def cells(looks, rate):
    return len(walls_of(corrected(looks, rate), looks))


def find_rate(looks):
    """How fast the believed heading drifts, in degrees/s."""
    best = min((i / 20 for i in range(-8, 9)), key=lambda rate: cells(looks, rate))
    return min((best + i / 100 for i in range(-5, 6)), key=lambda rate: cells(looks, rate))


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
