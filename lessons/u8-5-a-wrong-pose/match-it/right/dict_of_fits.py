# style: a dict of all fits, complex numbers, a while loop over the hits
import cmath


def fit(field, x, y, facing, hits):
    ahead = cmath.rect(1, math.radians(90 - facing))
    across = ahead * -1j
    total, i = 0, 0
    while i < len(hits):
        point = complex(x, y) + hits[i][0] * ahead + hits[i][1] * across
        column, row = math.floor(point.real / CELL), math.floor(point.imag / CELL)
        i += 1
        if not 0 <= column <= ACROSS - 1:
            continue
        if not 0 <= row <= ACROSS - 1:
            continue
        total += field[column + ACROSS * row]
    return total / i


def match(field, x, y, facing, hits):
    fits = {
        (x + dx, y + dy, facing + turned): fit(field, x + dx, y + dy, facing + turned, hits)
        for dx in SHIFTS
        for dy in SHIFTS
        for turned in TURNS
    }
    most = max(fits.values())
    return next(pose for pose, found in fits.items() if found == most)
