# style: its own beams, each cell once, up to the hit
def cells_to(x, y, way, length):
    """The cells of fine steps, without doubles, in their order."""
    fine = [i * CELL / 20 for i in range(int(length / (CELL / 20)) + 1)]
    points = ((x + d * math.sin(way), y + d * math.cos(way)) for d in fine)
    cells = dict.fromkeys((math.floor(px / CELL), math.floor(py / CELL)) for px, py in points)
    return [(c, r) for c, r in cells if 0 <= c < ACROSS and 0 <= r < ACROSS]


def look():
    """Add one scan to the map, from where the robot is now."""
    x, y = START[0] + position()[0], START[1] + position()[1]
    for angle, reading in scan():
        way = math.radians(heading() + angle)
        free = cells_to(x, y, way, min(reading, FAR))
        if reading < FAR:
            column = math.floor((x + reading * math.sin(way)) / CELL)
            row = math.floor((y + reading * math.cos(way)) / CELL)
            free = [cell for cell in free if cell != (column, row)]
            if 0 <= column < ACROSS and 0 <= row < ACROSS:
                cell = row * ACROSS + column
                log_odds[cell] = min(L_MAX, log_odds[cell] + L_OCC)
        for column, row in free:
            cell = row * ACROSS + column
            log_odds[cell] = max(-L_MAX, log_odds[cell] + L_FREE)


def drive_and_map():
    """Drive the circle, and look ten times a second."""
    drive(100, 0, 25)
    for _ in range(120):
        look()
        wait(0.1)
    stop()
    show()
