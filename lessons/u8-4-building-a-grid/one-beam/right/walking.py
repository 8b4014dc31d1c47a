# style: a while loop that walks half a cell at a time
def add_beam(log_odds, x, y, angle, reading):
    way = math.radians(angle)
    if reading >= FAR:
        clear = FAR
    else:
        clear = reading - CELL

    def add(d, amount):
        col = math.floor((x + d * math.sin(way)) / CELL)
        row = math.floor((y + d * math.cos(way)) / CELL)
        if col < 0 or col >= ACROSS:
            return
        if row < 0 or row >= ACROSS:
            return
        n = col + row * ACROSS
        log_odds[n] += amount
        if log_odds[n] > L_MAX:
            log_odds[n] = L_MAX
        if log_odds[n] < -L_MAX:
            log_odds[n] = -L_MAX

    d = 0
    while d < clear:
        add(d, L_FREE)
        d += CELL / 2
    if reading < FAR:
        add(reading, L_OCC)
