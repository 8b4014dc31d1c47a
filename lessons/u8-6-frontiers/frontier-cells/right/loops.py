# style: plain loops and four questions
def find_frontier(free, occupied):
    known = free | occupied
    frontier = set()
    for cell in free:
        c, r = cell
        if c > 0 and (c - 1, r) not in known:
            frontier.add(cell)
        if c < ACROSS - 1 and (c + 1, r) not in known:
            frontier.add(cell)
        if r > 0 and (c, r - 1) not in known:
            frontier.add(cell)
        if r < ACROSS - 1 and (c, r + 1) not in known:
            frontier.add(cell)
    return frontier
