# style: a beam of its own, walked with while
def add_scan(log_odds, x, y, facing, readings):
    for pair in readings:
        way = math.radians(facing + pair[0])
        clear = FAR if pair[1] >= FAR else pair[1] - CELL
        d = 0
        while d < clear:
            add(log_odds, x + d * math.sin(way), y + d * math.cos(way), L_FREE)
            d += CELL / 2
        if pair[1] < FAR:
            add(log_odds, x + pair[1] * math.sin(way), y + pair[1] * math.cos(way), L_OCC)


def add(log_odds, px, py, amount):
    column, row = math.floor(px / CELL), math.floor(py / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        n = row * ACROSS + column
        log_odds[n] = max(-L_MAX, min(L_MAX, log_odds[n] + amount))
