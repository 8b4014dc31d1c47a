# style: a loop that appends, and format()
def drifted(looks, rate):
    """The looks with a heading that drifts by so many degrees/s."""
    seen = []
    for look in looks:
        seconds, believed, readings = look
        believed += rate * seconds
        seen.append((seconds, believed, readings))
    return seen


def experiment(looks):
    """Print, for each of DRIFTS, how much of the map is wrong."""
    for number in range(len(DRIFTS)):
        cells = map_of(drifted(looks, DRIFTS[number]))
        show(*cells)
        print("drift {}: {:.2f} % wrong".format(DRIFTS[number], wrong_percent(cells[1])))
