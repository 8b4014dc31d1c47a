# style: recursion: the image of the rest, then the lowest row
def image_rows(log_odds, across):
    if len(log_odds) == 0:
        return []
    lowest = [205] * across
    for column, l in enumerate(log_odds[:across]):
        if 1 / (1 + math.exp(-l)) > 0.65:
            lowest[column] = 0
        elif 1 / (1 + math.exp(l)) > 0.65:
            lowest[column] = 254
    return image_rows(log_odds[across:], across) + [lowest]


def settings(image, cell_cm):
    made = dict(image=image, negate=False, origin=[0, 0, 0.0])
    made["resolution"] = cell_cm * 0.01
    made["free_thresh"] = 0.15
    made["occupied_thresh"] = 0.8
    return made
