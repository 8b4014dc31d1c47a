# style: recursion over the pairs
def add_scan(log_odds, x, y, facing, readings):
    if len(readings) == 0:
        return
    first, *others = readings
    angle, reading = first
    add_beam(log_odds, x, y, facing + angle, reading)
    add_scan(log_odds, x, y, facing, others)
