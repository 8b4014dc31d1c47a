# style: a turning matrix, without atan2
def speeds(dx, dy, facing):
    length = math.hypot(dx, dy)
    if not length:
        return [0, 0]
    s, c = math.sin(math.radians(facing)), math.cos(math.radians(facing))
    ahead = dx * s + dy * c
    right_hand = dx * c - dy * s
    return [100 * ahead / length, 100 * right_hand / length]
