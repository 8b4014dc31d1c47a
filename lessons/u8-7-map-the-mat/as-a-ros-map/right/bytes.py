# style: rows of bytes, as a P5 file has them, and the log odds of both limits
OCCUPIED_FROM = math.log(0.65 / 0.35)
FREE_BELOW = -OCCUPIED_FROM


def grey(l):
    if l > OCCUPIED_FROM:
        return 0
    return 254 if l < FREE_BELOW else 205


def image_rows(log_odds, across):
    greys = bytes(map(grey, log_odds))
    starts = range(len(greys) - across, -1, -across)
    return [greys[start : start + across] for start in starts]


def settings(image, cell_cm):
    thresholds = {"free_thresh": 0.1, "occupied_thresh": 0.9}
    place = {"origin": [0.0] * 3, "resolution": round(cell_cm / 100, 4)}
    return thresholds | place | {"negate": 0, "image": "./" + image}
