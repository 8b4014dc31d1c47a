# style: recursion

x, y = START[0] + position()[0], START[1] + position()[1]


def add(beams):
    if not beams:
        return
    (angle, reading), *others = beams
    passed, hit = beam_says(x, y, heading() + angle, reading)
    free.update(passed)
    if hit is not None:
        hits.add(hit)
    add(others)


add(scan())
