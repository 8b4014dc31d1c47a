# style: each cell's probability, in a plain loop
def read_map(log_odds):
    free = set()
    occupied = set()
    for cell in log_odds:
        p = 1 - 1 / (1 + math.exp(log_odds[cell]))
        if p > OCC_P:
            occupied.add(cell)
        elif p < FREE_P:
            free.add(cell)
    return free, occupied
