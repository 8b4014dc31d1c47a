# style: complex numbers: the root of the summed squares
import cmath


def wall_direction(looks):
    points = [
        cmath.rect(reading, math.radians(90 - facing - angle))
        for facing, readings in looks
        for angle, reading in readings
        if reading < FAR
    ]
    middle = sum(points) / len(points)
    along = sum((p - middle) ** 2 for p in points)
    return (90 - math.degrees(cmath.phase(along)) / 2) % 180


def drift_rate(first, second, seconds):
    one, two = (cmath.rect(1, 2 * math.radians(wall_direction(each))) for each in (first, second))
    return math.degrees(cmath.phase(two / one)) / 2 / seconds
