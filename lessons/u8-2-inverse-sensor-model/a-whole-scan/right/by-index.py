# style: angles and readings apart, by index

x, y = START[0] + position()[0], START[1] + position()[1]
angles, readings = zip(*scan())
for i in range(len(angles)):
    passed, hit = beam_says(x, y, heading() + angles[i], readings[i])
    free.update(passed)
    if hit is not None:
        hits.add(hit)
