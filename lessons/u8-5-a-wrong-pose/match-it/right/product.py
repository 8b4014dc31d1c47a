# style: itertools.product and max() with a key
from itertools import product


def fit(field, x, y, facing, hits):
    def agreement(point):
        column, row = int(point[0] // CELL), int(point[1] // CELL)
        if min(column, row) < 0 or max(column, row) >= ACROSS:
            return 0.0
        return field[column + ACROSS * row]

    return math.fsum(map(agreement, on_mat(x, y, facing, hits))) / len(hits)


def match(field, x, y, facing, hits):
    poses = ((x + dx, y + dy, facing + turn) for turn, dx, dy in product(TURNS, SHIFTS, SHIFTS))
    return max(poses, key=lambda pose: fit(field, *pose, hits))
