# style: complex numbers: a turn is a product
import cmath


def corrected(looks, rate):
    where = complex(looks[0][1], looks[0][2])
    poses = [(where.real, where.imag, looks[0][3] - rate * looks[0][0])]
    for old, new in zip(looks, looks[1:]):
        step = complex(new[1], new[2]) - complex(old[1], old[2])
        where += step * cmath.exp(1j * math.radians(rate * new[0]))
        poses.append((where.real, where.imag, new[3] - rate * new[0]))
    return poses
