# style: prints a scan and a distance, to see them

print("before:", scan())
x, y = START[0] + position()[0], START[1] + position()[1]
for angle, reading in scan():
    passed, hit = beam_says(x, y, heading() + angle, reading)
    free.update(passed)
    if hit is not None:
        hits.add(hit)
print("after:", scan(), "ahead:", distance())
