# style: asks scan() anew for each beam

x, y = START[0] + position()[0], START[1] + position()[1]
for i in range(len(scan())):
    angle, reading = scan()[i]
    passed, hit = beam_says(x, y, heading() + angle, reading)
    free.update(passed)
    if hit is not None:
        hits.add(hit)
