# Up the mat, with the eyes open
#
# The robot drives straight up the mat. It may turn while
# it does so: then it looks in all directions on the way.

from bugbot import *
import math

SPIN = 60  # per cent: how fast it turns while it drives (0 to 100)

L_OCC, L_FREE, L_MAX, KNOWN = 0.85, -0.4, 8, 0.62
CELL, ACROSS, FAR = 5, 40, 170
START = (100, 25)
log_odds = [0.0] * (ACROSS * ACROSS)  # rows, from the bottom up


def look():
    x, y = START[0] + position()[0], START[1] + position()[1]
    for angle, reading in scan():
        way = math.radians(heading() + angle)
        clear = reading - CELL if reading < FAR else FAR
        evidence = [(i * CELL / 2, L_FREE) for i in range(int(clear / (CELL / 2)))]
        if reading < FAR:
            evidence.append((reading, L_OCC))
        for along, weight in evidence:
            column = math.floor((x + along * math.sin(way)) / CELL)
            row = math.floor((y + along * math.cos(way)) / CELL)
            if 0 <= column < ACROSS and 0 <= row < ACROSS:
                cell = row * ACROSS + column
                log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def show():
    centres = [((i % ACROSS + 0.5) * CELL, (i // ACROSS + 0.5) * CELL) for i in range(ACROSS**2)]
    free = [centre for centre, l in zip(centres, log_odds) if l < -KNOWN]
    occupied = [centre for centre, l in zip(centres, log_odds) if l > KNOWN]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / ACROSS**2)


turn(-heading())  # to face up the mat
began = clock()
for tick in range(87):  # 8.7 seconds at 11.5 cm/s
    off = math.radians(0 - heading() - 0.06 * SPIN)  # up the mat is 0 degrees
    drive(100 * math.cos(off), 100 * math.sin(off), SPIN)
    wait(0.1)
    look()
    if tick % 5 == 0:
        show()
stop()
show()
print(f"It drove {math.hypot(*position()):.0f} cm in {clock() - began:.1f} s.")
