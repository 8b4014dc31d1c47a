# style: A* from the goal back to the start, with an octile estimate
def find_way(start, goal, room):
    def estimate(cell):
        dc, dr = abs(cell[0] - start[0]), abs(cell[1] - start[1])
        return max(dc, dr) + (2**0.5 - 1) * min(dc, dr)

    came = {goal: None}
    cost = {goal: 0.0}
    heap = [(estimate(goal), 0, goal)]
    pushed = 0
    while heap:
        _, _, cell = heappop(heap)
        if cell == start:
            way = ()
            while cell is not None:
                way += (cell,)
                cell = came[cell]
            return way
        for c, r in CORNERS + SIDES:
            new = (cell[0] + c, cell[1] + r)
            if new not in room or (new[0], cell[1]) not in room or (cell[0], new[1]) not in room:
                continue
            if new not in cost or cost[cell] + dist(cell, new) < cost[new]:
                cost[new] = cost[cell] + dist(cell, new)
                came[new] = cell
                pushed += 1
                heappush(heap, (cost[new] + estimate(new), pushed, new))
    return ()
