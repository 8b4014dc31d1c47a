# earns: has to stay as it was
# Without the drift
#
# The robot drives five times round its ring. Its belief
# drifts (red). You know the rate: take the drift out, of
# the heading and of every step, and the way is round
# again (green). The camera saw the true one (black).

from bugbot import *
import math

START = (72, 100)  # where it starts; odometry() counts from there


# ---- your part ----
def corrected(looks, rate):
    """The poses of the looks without the drift: a list of (x, y, facing).

    looks: (time, x, y, facing, ...) as odometry() had them
    rate: how fast the heading drifts, in degrees/s
    """
    poses = []
    x, y = looks[0][1:3]
    before = looks.pop(0)
    poses.append((x, y, before[3] - rate * before[0]))
    for look in looks:
        turned = math.radians(rate * look[0])
        dx, dy = look[1] - before[1], look[2] - before[2]
        x += dx * math.cos(turned) - dy * math.sin(turned)
        y += dy * math.cos(turned) + dx * math.sin(turned)
        poses.append((x, y, look[3] - rate * look[0]))
        before = look
    return poses


# ---- end of your part ----


looks, true = [], []
drive(100, 0, 25)
for tick in range(300):  # 60 seconds
    looks.append((clock(), *odometry()))
    true.append((START[0] + position()[0], START[1] + position()[1]))
    wait(0.2)
stop()

turned = (odometry()[2] - heading() + 180) % 360 - 180
rate = turned / clock()
print(f"drift: {rate:.3f} degrees/s")
way = corrected(looks, rate)
draw(
    "as it believes",
    [(START[0] + e[1], START[1] + e[2]) for e in looks],
    "red",
    "line",
    1,
)
draw("corrected", [(START[0] + e[0], START[1] + e[1]) for e in way], "green", "line", 1)
draw("true", true, "black", "line", 0.5)
