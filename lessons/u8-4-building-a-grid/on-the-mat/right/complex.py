# style: complex numbers
import cmath


def pose():
    here = complex(*START) + complex(*position())
    return here.real, here.imag, heading()


def look():
    x, y, facing = pose()
    trail.append((x, y))
    for angle, reading in scan():
        if reading < FAR:
            end = complex(x, y) + cmath.rect(reading, math.pi / 2 - math.radians(facing + angle))
            walls.append((end.real, end.imag))
