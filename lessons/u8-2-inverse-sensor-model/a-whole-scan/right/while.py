# style: a while loop that takes beams off a list

beams = list(scan())
x, y = (a + b for a, b in zip(START, position()))
while beams:
    angle, reading = beams.pop()
    passed, hit = beam_says(x, y, angle + heading(), reading)
    free.update(passed)
    hits.update([hit] if hit is not None else [])
