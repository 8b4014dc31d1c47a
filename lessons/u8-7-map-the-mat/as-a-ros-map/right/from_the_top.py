# style: row by row from the top, with a mode as nav2 has it
def grey(l):
    odds = math.exp(l)
    p = odds / (1 + odds)
    if p > 0.65:
        return 0
    if p < 0.35:
        return 254
    return 205


def image_rows(log_odds, across):
    rows = []
    for row in range(across - 1, -1, -1):
        rows.append(tuple(grey(log_odds[row * across + column]) for column in range(across)))
    return rows


def settings(image, cell_cm):
    return {
        "image": image,
        "mode": "trinary",
        "resolution": cell_cm / 100,
        "origin": [0.0, 0.0, 0.0],
        "negate": 0,
        "occupied_thresh": 0.65,
        "free_thresh": 0.1,
    }
