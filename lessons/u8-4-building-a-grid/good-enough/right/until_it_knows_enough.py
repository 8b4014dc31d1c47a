# style: goes to the next stop until so much is known, or the time is up
def known():
    return sum(abs(l) > KNOWN for l in log_odds) / len(log_odds)


def face(x, y):
    dx, dy = x - START[0] - position()[0], y - START[1] - position()[1]
    turn((math.degrees(math.atan2(dx, dy)) - heading() + 180) % 360 - 180, speed=100)
    return math.hypot(dx, dy)


def explore():
    """The whole route."""
    for stop_at in [(100, 95), (35, 100), (165, 100), (100, 100), (100, 165)]:
        length = face(*stop_at)
        forward(100)
        keep_mapping(length / 11.5)
        seen, ticks = known(), 0
        right(50)
        while ticks < 60 and clock() < 73:
            look()
            wait(0.1)
            ticks += 1
        stop()
        if known() > 0.95 or clock() > 73:
            break
    show()
