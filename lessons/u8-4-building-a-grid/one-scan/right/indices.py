# style: indices and a while loop
def add_scan(log_odds, x, y, facing, readings):
    i = 0
    while i < len(readings):
        add_beam(log_odds, x, y, angle=readings[i][0] + facing, reading=readings[i][1])
        i += 1
