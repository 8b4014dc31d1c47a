# style: odds, compared by multiplying out
def read_map(log_odds):
    odds = {cell: math.exp(value) for cell, value in log_odds.items()}
    free = set(filter(lambda cell: odds[cell] * (1 - FREE_P) < FREE_P, odds))
    occupied = set(filter(lambda cell: odds[cell] * (1 - OCC_P) > OCC_P, odds))
    return [free, occupied]
