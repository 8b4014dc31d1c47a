# style: recursion over the hits and over the poses
def agreement(field, points):
    if not points:
        return 0
    px, py = points[0]
    rest = agreement(field, points[1:])
    if not (0 <= px < ACROSS * CELL and 0 <= py < ACROSS * CELL):
        return rest
    return rest + field[int(py / CELL) * ACROSS + int(px / CELL)]


def fit(field, x, y, facing, hits):
    points = on_mat(x, y, facing, hits)
    parts = [points[i : i + 50] for i in range(0, len(points), 50)]
    return sum(agreement(field, part) for part in parts) / len(hits)


def better(field, hits, first, others):
    if not others:
        return first
    rest = better(field, hits, others[0], others[1:])
    return rest if fit(field, *rest, hits) > fit(field, *first, hits) else first


def match(field, x, y, facing, hits):
    best = (x, y, facing)
    for turn in TURNS:
        places = [(x + dx, y + dy, facing + turn) for dx in SHIFTS for dy in SHIFTS]
        best = better(field, hits, best, places)
    return best
