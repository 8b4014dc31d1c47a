# style: a queue, and frozen sets in a tuple
from collections import deque


def find_regions(cells):
    seen, regions = set(), []
    for start in sorted(cells):
        if start in seen:
            continue
        queue, region = deque([start]), {start}
        while queue:
            x, y = queue.popleft()
            for dx, dy in [*SIDES, *CORNERS]:
                near = (x + dx, y + dy)
                if near in cells and near not in region:
                    region.add(near)
                    queue.append(near)
        seen |= region
        regions.append(frozenset(region))
    return tuple(regions)
