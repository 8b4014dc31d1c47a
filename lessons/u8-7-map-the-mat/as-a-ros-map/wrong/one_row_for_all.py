# earns: every row is one and the same list
# As a ROS map
#
# Two functions make a map that a ROS robot can load: the
# greys of the image, and the settings beside it.

from bugbot import *
import math

L_OCC, L_FREE, L_MAX = 0.85, -0.4, 8
CELL, ACROSS, FAR = 5, 40, 170
START = (100, 25)  # where it starts; position() counts from there
log_odds = [0.0] * (ACROSS * ACROSS)  # rows, from the bottom up


# ---- your part ----
def image_rows(log_odds, across):
    image = [[205] * across] * across
    for number, l in enumerate(log_odds):
        p = 1 - 1 / (1 + math.exp(l))
        row, column = divmod(number, across)
        image[across - 1 - row][column] = 0 if p > 0.65 else 254 if p < 0.35 else 205
    return image


def settings(image, cell_cm):
    """The settings for the YAML file, as a dictionary.

    image, resolution (metres a cell), origin [x, y, turn] of
    the lower left corner, negate, occupied_thresh, free_thresh.
    The thresholds are for reading the greys: 205 must come
    back as unknown.
    """
    return {
        "image": image,
        "resolution": cell_cm / 100,
        "origin": [0, 0, 0],
        "negate": 0,
        "occupied_thresh": 0.65,
        "free_thresh": 0.196,
    }


# ---- end of your part ----


# The rest is done: a small mapper, and the files it would write.
def look():
    """Add one scan to the map."""
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


right(60)
for tick in range(50):
    look()
    wait(0.1)
stop()
rows = image_rows(log_odds, ACROSS)
looks = {0: "#", 205: "?", 254: "."}
for row in rows:
    print("".join(looks.get(grey, "!") for grey in row))
for name, value in settings("map.pgm", CELL).items():
    print(f"{name}: {value}")
