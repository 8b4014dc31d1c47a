# style: gentle lines to the right only; the others are mirrored


def gentle(a, b):
    (c0, r0), (c1, r1) = a, b
    wide, high = c1 - c0, abs(r1 - r0)
    up = 1 if r1 > r0 else -1
    out, r, drift = [], r0, 0
    for c in range(c0, c1 + 1):
        out.append((c, r))
        drift += 2 * high
        if drift > wide:
            drift -= 2 * wide
            r += up
    return out


steep = abs(last[1] - row) > abs(last[0] - column)
flip = (lambda p: (p[1], p[0])) if steep else (lambda p: p)
a, b = flip(first), flip(last)
back = a[0] > b[0]
if back:
    a, b = b, a
cells = [flip(p) for p in gentle(a, b)]
if back:
    cells.reverse()
