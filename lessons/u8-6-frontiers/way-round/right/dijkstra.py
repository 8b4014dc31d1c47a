# style: Dijkstra: no estimate, and a set of finished cells
def find_way(start, goal, room):
    done = set()
    waiting = [(0, start, [start])]
    while waiting:
        length, cell, way = heappop(waiting)
        if cell == goal:
            return way
        if cell in done:
            continue
        done.add(cell)
        c, r = cell
        for i in (1, 0, -1):
            for j in (1, 0, -1):
                if (c + i, r + j) in room and (c + i, r) in room and (c, r + j) in room:
                    heappush(
                        waiting,
                        (length + (i * i + j * j) ** 0.5, (c + i, r + j), [*way, (c + i, r + j)]),
                    )
    return []
