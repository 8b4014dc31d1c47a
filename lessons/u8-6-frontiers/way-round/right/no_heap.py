# style: a list in place of the heap, the smallest found with min()
def find_way(start, goal, room):
    length = {start: 0}
    before = {}
    waiting = {start}
    while waiting:
        cell = min(waiting, key=lambda each: length[each] + dist(each, goal))
        waiting.remove(cell)
        if cell == goal:
            way = [goal]
            while way[0] != start:
                way.insert(0, before[way[0]])
            return way
        for c in (-1, 0, 1):
            for r in (-1, 0, 1):
                new = (cell[0] + c, cell[1] + r)
                if not {new, (new[0], cell[1]), (cell[0], new[1])}.issubset(room):
                    continue
                if length[cell] + dist(cell, new) < length.get(new, 1000):
                    length[new] = length[cell] + dist(cell, new)
                    before[new] = cell
                    waiting.add(new)
    return []
