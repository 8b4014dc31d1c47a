# style: plain loops that keep the best so far
def nearest_cell(here, region):
    best = None
    shortest = 10**9
    for cell in region:
        d = ((cell[0] - here[0]) ** 2 + (cell[1] - here[1]) ** 2) ** 0.5
        if d < shortest:
            best, shortest = cell, d
    return best


def choose(here, regions, gain):
    best, best_worth = None, None
    for region in regions:
        cell = nearest_cell(here, region)
        worth = gain * len(region) - dist(here, cell)
        if best_worth is None or worth > best_worth:
            best, best_worth = cell, worth
    return best
