# style: complex numbers for places and turns
import cmath


def corrected(looks, rate):
    """The poses of the looks without the drift: (x, y, facing)."""
    poses, place, before = [], None, None
    for time, x, y, facing, readings in looks:
        believed = complex(x, y)
        if place is None:
            place = believed
        else:
            place += (believed - before) * cmath.exp(1j * math.radians(rate * time))
        before = believed
        poses.append((place.real, place.imag, facing - rate * time))
    return poses


def find_rate(looks):
    """How fast the believed heading drifts, in degrees/s."""
    sizes = {}
    for hundredths in range(-42, 43, 2):
        rate = hundredths / 100
        sizes[len(walls_of(corrected(looks, rate), looks))] = rate
    return sizes[min(sizes)]
