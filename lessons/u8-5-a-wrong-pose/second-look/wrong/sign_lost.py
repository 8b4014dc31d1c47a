# earns: the sign is lost
# A second look at the same wall
#
# The robot looks at the wall, spins for 50 seconds, and
# looks at the same wall again. If it believes the wall
# to have turned meanwhile, it is its gyro that drifts.

from bugbot import *
import math

FAR = 170  # a reading this long or longer found no wall [cm]


# ---- your part ----
def wall_direction(looks):
    points = []
    for facing, readings in looks:
        for angle, reading in readings:
            if reading < FAR:
                way = math.radians(facing + angle)
                points.append((reading * math.sin(way), reading * math.cos(way)))
    mx = sum(p[0] for p in points) / len(points)
    my = sum(p[1] for p in points) / len(points)
    sxx = sum((x - mx) ** 2 for x, y in points)
    syy = sum((y - my) ** 2 for x, y in points)
    sxy = sum((x - mx) * (y - my) for x, y in points)
    return math.degrees(math.atan2(2 * sxy, syy - sxx)) / 2 % 180


def drift_rate(first, second, seconds):
    turned = (wall_direction(second) - wall_direction(first)) % 180
    return min(turned, 180 - turned) / seconds


# ---- end of your part ----


def look(times):
    """Look so often; each time with the heading that odometry has."""
    looks = []
    for each in range(times):
        looks.append((odometry()[2], scan()))
        wait(0.1)
    return looks


def show(name, looks, colour):
    """Where the hits are, seen from the robot's place in the middle."""
    points = []
    for facing, readings in looks:
        for angle, reading in readings:
            if reading < FAR:
                way = math.radians(facing + angle)
                x, y = reading * math.sin(way), reading * math.cos(way)
                points.append((100 + x, 40 + y))
    draw(name, points, colour, "dots", 1.5)


first = look(20)
show("first look", first, "blue")
right(60)  # 72 degrees a second: ten times round
wait(50)
stop()
second = look(20)
show("second look", second, "red")
print(f"drift: {drift_rate(first, second, 52):.3f} degrees/s")
