# style: recursion: each goal is followed by the exploring of the rest

import numpy as np


def choose_goal(here, frontier, room, tried):
    regions = sorted(find_regions(frontier - tried), key=len, reverse=True)
    if len(frontier) < 1:
        return None, "no frontier is left"
    if not regions or len(regions[0]) < MIN_REGION:
        return None, "only small frontiers are left"
    reached = np.array(flood(here, room, SIDES))
    costs = []
    for region in regions:
        if len(region) < MIN_REGION:
            break
        gaps = np.hypot(*(reached[:, None, :] - np.array(region)[None, :, :]).T).min(axis=0)
        order = np.flatnonzero(gaps * CELL < NEAR)
        if order.size:  # the flood has the nearest first
            costs.append((int(order[0]) - 5 * len(region), int(order[0])))
    if not costs:
        return None, "no frontier can be reached"
    column, row = reached[min(costs)[1]]
    return (int(column), int(row)), None


def situation():
    free, occupied, frontier = read_map()
    edge = find_edge(free)
    room = find_room(free, edge)
    return frontier, edge, room, own_cell(free, room)


def go(goal, tried, tries):
    """Drive to the goal as long as something is left to see there."""
    frontier, edge, room, here = situation()
    if tries == 0 or here is None or not near(goal, frontier - tried):
        return tried
    if dist(where(), centre(goal)) <= 3:
        look_round()
        return tried | {cell for cell in read_map()[2] if near(cell, [goal])}
    way = find_way(here, goal, room)
    if not way:
        return tried
    drive_along(way, edge)
    return go(goal, tried, tries - 1)


def rest(tried):
    if clock() >= MAX_TIME:
        return "time is up"
    frontier, edge, room, here = situation()
    if here is None:
        return "no room"
    goal, why = choose_goal(here, frontier, room, tried)
    return why or rest(go(goal, tried, 60))


def explore():
    look_round()
    return rest(set())
