# style: Dijkstra of its own, once, and the cheapest spot of all
from collections import deque
from itertools import chain


def distances(here, room):
    """Steps from here to every cell of the room that can be reached."""
    steps, waiting = {here: 0}, deque([here])
    while waiting:
        cell = waiting.popleft()
        for new in beside(cell, SIDES) & room:
            if new not in steps:
                steps[new] = steps[cell] + 1
                waiting.append(new)
    return steps


def choose_goal(here, frontier, room, tried):
    if not frontier:
        return None, "no frontier is left"
    large = [r for r in find_regions(set(frontier) - set(tried)) if not len(r) < MIN_REGION]
    if not large:
        return None, "only small frontiers are left"
    wanted = set(chain.from_iterable(large))
    steps = distances(here, room)
    spots = {cell for cell in steps if near(cell, wanted)}
    if not spots:
        return None, "no frontier can be reached"
    return min(spots, key=lambda cell: (steps[cell], cell)), None


def explore():
    tried, goal = [], None
    look_round()
    while clock() < MAX_TIME:
        free, occupied, frontier = read_map()
        edge = find_edge(free)
        room = find_room(free, edge)
        here = own_cell(free, room)
        if not here:
            return "it stands in no room"
        if goal is None or goal not in room or not near(goal, frontier - set(tried)):
            goal, why = choose_goal(here, frontier, room, set(tried))
            if why is not None:
                return why
        if dist(where(), centre(goal)) <= 4:
            look_round()
            tried.extend(cell for cell in read_map()[2] if near(cell, [goal]))
            goal = None
            continue
        way = find_way(here, goal, room)
        if way:
            drive_along(way, edge)
        else:
            goal = None
    return "time is up"
