# style: odds, multiplied


def fuse(readings):
    odds = 1
    for p in readings:
        odds *= p / (1 - p)
    return odds / (1 + odds)
