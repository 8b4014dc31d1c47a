# style: None added like a cell, and discarded at the end

x, y = START[0] + position()[0], START[1] + position()[1]
for angle, reading in scan():
    passed, hit = beam_says(x, y, heading() + angle, reading)
    free.update(passed)
    hits.add(hit)
hits.discard(None)
