# style: four shifted copies of the unknown set
def find_frontier(free, occupied):
    unknown = {(c, r) for c in range(ACROSS) for r in range(ACROSS)}.difference(free, occupied)
    shifted = [{(c + i, r + j) for c, r in unknown} for i, j in SIDES]
    return frozenset(free.intersection(set.union(*shifted)))
