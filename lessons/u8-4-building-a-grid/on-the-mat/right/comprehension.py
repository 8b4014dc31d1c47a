# style: one comprehension, indices for pairs
def pose():
    return [s + p for s, p in zip(START, position())] + [heading()]


def look():
    global walls
    x, y, facing = pose()
    trail.append([x, y])
    directions = [(math.radians(facing + beam[0]), beam[1]) for beam in scan()]
    walls += [[x + r * math.sin(w), y + r * math.cos(w)] for w, r in directions if r < FAR]
