# style: complex numbers: divided by the way it faces
import cmath


def speeds(dx, dy, facing):
    way = complex(dy, dx)
    if way == 0:
        return 0.0, 0.0
    seen = 100 * way / abs(way) / cmath.exp(1j * math.radians(facing))
    return seen.real, seen.imag
