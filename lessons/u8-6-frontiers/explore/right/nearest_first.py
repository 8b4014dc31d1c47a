# style: the nearest frontier always, by one flood through the room
def choose_goal(here, frontier, room, tried):
    left = frontier - tried
    if len(frontier) == 0:
        return (None, "no frontier is left")
    large = set()
    for region in find_regions(left):
        if len(region) >= MIN_REGION:
            large.update(region)
    if len(large) == 0:
        return (None, "only small frontiers are left")
    for cell in flood(here, room, SIDES):  # the nearest first
        if near(cell, large):
            return (cell, None)
    return (None, "no frontier can be reached")


def explore():
    tried = set()
    look_round()
    while True:
        if clock() >= MAX_TIME:
            return "time is up"
        free, _, frontier = read_map()
        edge = find_edge(free)
        room = find_room(free, edge)
        here = own_cell(free, room)
        if here is None:
            return "the robot has no room"
        goal, why = choose_goal(here, frontier, room, tried)
        if goal is None:
            return why
        # Go there, with the map as it is; then look, and choose again.
        for _ in range(40):
            free, _, frontier = read_map()
            edge = find_edge(free)
            room = find_room(free, edge)
            here = own_cell(free, room)
            way = find_way(here, goal, room) if here else []
            if not way or dist(where(), centre(goal)) < 3 or not near(goal, frontier - tried):
                break
            drive_along(way, edge)
        look_round()
        if dist(where(), centre(goal)) < 5:
            tried = tried | {cell for cell in read_map()[2] if near(cell, [goal])}
