# style: angles from the x axis, counter-clockwise
def pose():
    dx, dy = position()
    return (START[0] + dx, START[1] + dy, heading())


def look():
    x, y, facing = pose()
    trail.append((x, y))
    for angle, reading in scan():
        if reading >= FAR:
            continue
        theta = math.radians(90 - facing - angle)
        walls.append((x + reading * math.cos(theta), y + reading * math.sin(theta)))
