# style: complex numbers and the smallest gap
def straight_way(start, goal, walls):
    a, b = complex(*start), complex(*goal)
    points = [a + (b - a) * i / 400 for i in range(401)]
    centres = [CELL * complex(c + 0.5, r + 0.5) for c, r in walls]
    return min((abs(p - m) for p in points for m in centres), default=1e9) >= SPARE + CELL / 2
