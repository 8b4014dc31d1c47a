# style: recursion from the top row down, and odds; settings as the texts of a YAML file
def image_rows(log_odds, across):
    if not log_odds:
        return []
    *below, top = range(0, len(log_odds), across)
    row = []
    for l in log_odds[top:]:
        odds = math.exp(l)
        if odds * 0.35 > 0.65:
            row.append(0)
        elif odds * 0.65 < 0.35:
            row.append(254)
        else:
            row.append(205)
    return [row] + image_rows(log_odds[:top], across)


YAML = """
# thresholds first
free_thresh: 0.15
occupied_thresh: 0.6
negate: 0
origin: [0.0, 0.0, 0.0]
resolution: {metres}
image: '{image}'
"""


def settings(image, cell_cm):
    told = {}
    for line in YAML.format(image=image, metres=cell_cm / 100).splitlines():
        name, colon, value = line.partition(": ")
        if colon and not line.startswith("#"):
            told[name] = value
    return told
