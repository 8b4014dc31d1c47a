# style: turns while it drives, by working out forward and sideways at each tick
def go(x, y, spin=60):
    """Straight to a point, turning meanwhile, and mapping."""
    while True:
        dx, dy = x - START[0] - position()[0], y - START[1] - position()[1]
        if math.hypot(dx, dy) < 1:
            break
        off = math.atan2(dx, dy) - math.radians(heading() + 0.06 * spin)
        speed = min(100, 90 * math.hypot(dx, dy))
        drive(speed * math.cos(off), speed * math.sin(off), spin)
        look()
        wait(0.1)
    show()


def explore():
    """The whole route."""
    for x, y in [(100, 100), (32, 100), (168, 100), (100, 100), (100, 168)]:
        go(x, y)
        right(60)
        keep_mapping(5)
