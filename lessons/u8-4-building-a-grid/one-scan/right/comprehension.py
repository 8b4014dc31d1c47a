# style: a comprehension for what it does
def add_scan(log_odds, x, y, facing, readings):
    [add_beam(log_odds, x, y, (facing + angle) % 360, reading) for angle, reading in readings]
