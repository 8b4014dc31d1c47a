# style: complex numbers for points; the list is changed as a piece
import cmath


def add_beam(log_odds, x, y, angle, reading):
    start = complex(x, y)
    ahead = cmath.rect(1, math.radians(90 - angle))
    new = list(log_odds)
    clear = min(FAR, reading - CELL if reading < FAR else FAR)
    half_cells = [CELL / 2 * n for n in range(2 * ACROSS * 2) if CELL / 2 * n < clear]
    for along in half_cells + [reading] * (reading < FAR):
        point = start + along * ahead
        column, row = point.real // CELL, point.imag // CELL
        if not (0 <= min(column, row) and max(column, row) < ACROSS):
            continue
        weight = L_OCC if along == reading else L_FREE
        index = int(row) * ACROSS + int(column)
        new[index] = max(min(new[index] + weight, L_MAX), -L_MAX)
    log_odds[:] = new
