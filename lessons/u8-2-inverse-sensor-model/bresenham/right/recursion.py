# style: recursion

(c1, r1) = last
wide, high = c1 - column, r1 - row


def line(a, b):
    if abs(b[0] - a[0]) <= 1 and abs(b[1] - a[1]) <= 1:
        return [a, b] if a != b else [a]
    raise NotImplementedError


n = max(abs(wide), abs(high))


def walk(k):
    if k > n:
        return []
    here = (column + (2 * k * wide + n) // (2 * n), row + (2 * k * high + n) // (2 * n))
    return [here] + walk(k + 1)


cells += walk(1)
