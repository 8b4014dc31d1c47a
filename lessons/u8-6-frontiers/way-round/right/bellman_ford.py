# style: lengths made shorter until none changes
def find_way(start, goal, room):
    steps = SIDES + CORNERS
    far = {cell: 1e9 for cell in room}
    far[goal] = 0
    changed = True
    while changed:
        changed = False
        for c, r in room:
            for i, j in steps:
                near = {(c + i, r + j), (c + i, r), (c, r + j)}
                if near <= room and far[c + i, r + j] + dist((0, 0), (i, j)) < far[c, r] - 1e-9:
                    far[c, r] = far[c + i, r + j] + dist((0, 0), (i, j))
                    changed = True
    if far[start] >= 1e9:
        return []
    way = [start]
    while way[-1] != goal:
        c, r = way[-1]
        way.append(
            min(
                (
                    (c + i, r + j)
                    for i, j in steps
                    if {(c + i, r + j), (c + i, r), (c, r + j)} <= room
                ),
                key=lambda new: far[new] + dist((c, r), new),
            )
        )
    return way
