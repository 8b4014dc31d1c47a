# style: each step by its length and its own direction
def corrected(looks, rate):
    _, x, y, facing = looks[0][:4]
    poses = [[x, y, facing - rate * looks[0][0]]]
    i = 1
    while i < len(looks):
        time, new_x, new_y, facing = looks[i][:4]
        dx, dy = new_x - looks[i - 1][1], new_y - looks[i - 1][2]
        way = math.atan2(dx, dy) - math.radians(rate * time)
        length = math.hypot(dx, dy)
        x = x + length * math.sin(way)
        y = y + length * math.cos(way)
        poses.append([x, y, facing - rate * time])
        i += 1
    return poses
