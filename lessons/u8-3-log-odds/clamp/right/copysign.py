# style: the sign put back

import math


def add(l, evidence, limit):
    total = l + evidence
    return math.copysign(min(abs(total), limit), total)
