# Which drift makes the sharpest map?
#
# The robot drives four times round its ring and keeps
# its looks. Then it takes out one drift after another,
# and counts the cells that the hits fall into. Orange
# are the walls as it believed them, black those with
# the drift taken out that needs the fewest cells.

from bugbot import *
import math

# Numbers to change
ROUNDS = 4  # how often round the ring (1 to 6)
MOST = 0.4  # the largest drift to try, degrees a second (0.1 to 1)

CELL, FAR, START = 5, 170, (72, 100)


def corrected(looks, rate):
    """The poses of the looks with a drift taken out."""
    (x, y), before, poses = looks[0][1:3], looks[0], []
    for look in looks:
        turned = math.radians(rate * look[0])
        dx, dy = look[1] - before[1], look[2] - before[2]
        x += dx * math.cos(turned) - dy * math.sin(turned)
        y += dy * math.cos(turned) + dx * math.sin(turned)
        poses.append((x, y, look[3] - rate * look[0]))
        before = look
    return poses


def walls_of(poses, looks):
    """The cells in which beams ended, seen from these poses: a set."""
    cells = set()
    for (x, y, facing), look in zip(poses, looks):
        for angle, reading in look[4]:
            if reading < FAR:
                way = math.radians(facing + angle)
                column = math.floor((START[0] + x + reading * math.sin(way)) / CELL)
                row = math.floor((START[1] + y + reading * math.cos(way)) / CELL)
                cells.add((column, row))
    return cells


def show(name, rate, colour, size):
    """Draw the cells with a hit."""
    cells = walls_of(corrected(looks, rate), looks)
    middles = [((c + 0.5) * CELL, (r + 0.5) * CELL) for c, r in cells]
    draw(name, middles, colour, "squares", size)


looks = []
drive(100, 0, 25)
for tick in range(ROUNDS * 60):  # 12 seconds a round
    looks.append((clock(), *odometry(), scan()))
    wait(0.2)
stop()
true = ((odometry()[2] - heading() + 180) % 360 - 180) / clock()

count = {}
for step in range(-10, 11):
    rate = round(MOST * step / 10, 3)
    count[rate] = len(walls_of(corrected(looks, rate), looks))
    print(f"{rate:6.2f} degrees/s: {count[rate]} cells")
best = min(count, key=count.get)
show("as it believed", 0, "orange", 5)
show("sharpest", best, "black", 3)
print(f"sharpest with: {best:.2f} degrees/s, {count[best]} cells")
print(f"the true drift: {true:.3f} degrees/s")
