# style: a while loop that puts each row in front; scaled greys by a table; ordered pairs
from collections import OrderedDict, deque

GREYS = (254, 205, 0)


def image_rows(log_odds, across):
    rows, at = deque(), 0
    while at < len(log_odds):
        row = []
        while len(row) < across:
            p = 0.5 * (1 + math.tanh(log_odds[at] / 2))
            row.append(GREYS[(p >= 0.35) + (p > 0.65)])
            at += 1
        rows.appendleft(tuple(row))
    return rows


def settings(image, cell_cm):
    said = OrderedDict()
    said["image"] = f'"{image}"'
    said["origin"] = "[0, 0, 0]"
    said["resolution"] = f"{cell_cm / 100:.3f}"
    said["occupied_thresh"] = "0.650"
    said["free_thresh"] = "0.196"
    said["negate"] = "0"
    return said
