# style: the exact distance from each wall to the line
def straight_way(start, goal, walls):
    (x, y), (gx, gy) = start, goal
    dx, dy = gx - x, gy - y
    for column, row in walls:
        mx, my = (column + 0.5) * CELL, (row + 0.5) * CELL
        square = dx * dx + dy * dy
        share = 0 if square == 0 else ((mx - x) * dx + (my - y) * dy) / square
        share = min(1, max(0, share))
        if dist((x + share * dx, y + share * dy), (mx, my)) - CELL / 2 < SPARE:
            return False
    return True
