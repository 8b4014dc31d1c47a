# style: a while loop of half a centimetre
import math


def straight_way(start, goal, walls):
    length = dist(start, goal)
    angle = math.atan2(goal[1] - start[1], goal[0] - start[0])
    gone = 0
    points = []
    while gone < length:
        points.append((start[0] + gone * math.cos(angle), start[1] + gone * math.sin(angle)))
        gone += 0.5
    points.append(goal)
    ok = True
    for p in points:
        for wall in walls:
            gap = math.hypot(p[0] - (wall[0] + 0.5) * CELL, p[1] - (wall[1] + 0.5) * CELL)
            if gap - CELL / 2 < SPARE:
                ok = False
    return ok
