# style: two products of probabilities


def fuse(readings):
    yes = math.prod(readings)
    no = math.prod(1 - p for p in readings)
    return yes / (yes + no)
