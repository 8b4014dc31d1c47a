# style: recursion: one step, then the remaining ones
def clamped(value):
    return sorted((-L_MAX, value, L_MAX))[1]


def mark(log_odds, x, y, weight):
    column, row = math.floor(x / CELL), math.floor(y / CELL)
    if 0 <= column <= ACROSS - 1 and 0 <= row <= ACROSS - 1:
        place = ACROSS * row + column
        log_odds[place] = clamped(log_odds[place] + weight)


def add_beam(log_odds, x, y, angle, reading, gone=0.0):
    dx, dy = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    clear = FAR if reading >= FAR else reading - CELL
    if gone < clear:
        mark(log_odds, x + gone * dx, y + gone * dy, L_FREE)
        add_beam(log_odds, x, y, angle, reading, gone + CELL / 2)
    elif reading < FAR:
        mark(log_odds, x + reading * dx, y + reading * dy, L_OCC)
