# style: recursion: the line halved until its pieces are short
def straight_way(start, goal, walls):
    def clear(point):
        return all(
            dist(point, (CELL * c + CELL / 2, CELL * r + CELL / 2)) >= SPARE + CELL / 2
            for c, r in walls
        )

    def check(a, b):
        if not clear(b):
            return False
        if dist(a, b) <= 1:
            return True
        middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        return check(a, middle) and check(middle, b)

    return clear(start) and check(start, goal)
