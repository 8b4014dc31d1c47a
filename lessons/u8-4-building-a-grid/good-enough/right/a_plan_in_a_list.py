# style: a plan of commands in a list
PLAN = [
    *(("look", 0), ("drive", 75), ("look", 0)),
    *(("turn", -90), ("drive", 66), ("look", 0), ("back", 66)),
    *(("drive", -1), ("turn", 180), ("drive", 66), ("look", 0), ("back", 66)),
    *(("turn", -90), ("drive", 68), ("look", 0)),
]


def explore():
    """The whole route."""
    for what, size in PLAN:
        if what == "turn":
            turn(size, speed=100)
        elif what == "look":
            right(65)
            keep_mapping(4.6)
        elif size > 0:
            (forward if what == "drive" else backward)(100)
            keep_mapping(size / 11.5)
    stop()
