# style: recursion: the first thing or one of the rest
def gap(x, y, real):
    if not real:
        return min(x, y, MAT - x, MAT - y)
    (left, bottom, width, height), *rest = real
    right, top = left + width, bottom + height
    if left <= x <= right and bottom <= y <= top:
        own = 0
    elif left <= x <= right:
        own = bottom - y if y < bottom else y - top
    elif bottom <= y <= top:
        own = left - x if x < left else x - right
    else:
        own = min(math.dist((x, y), (cx, cy)) for cx in (left, right) for cy in (bottom, top))
    return min(own, gap(x, y, rest))


def wrong_percent(occupied, real):
    def count(points):
        if not points:
            return 0
        return (gap(points[0][0], points[0][1], real) > CELL) + count(points[1:])

    return 0 if not occupied else count(occupied) / len(occupied) * 100
