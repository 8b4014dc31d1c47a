# style: recursion, and more looks than were asked for
def look():
    """Add one scan to the map, from where the robot is now."""
    (dx, dy), facing = position(), heading()
    beams = [(START[0] + dx, START[1] + dy, facing + a, r) for a, r in scan()]
    [add_beam(*beam) for beam in beams]


def looks(left):
    if left:
        look()
        wait(0.05)
        looks(left - 1)


def drive_and_map():
    """Drive the circle, and look ten times a second."""
    drive(100, 0, 25)
    looks(240)
    stop()
