# style: a class that keeps goal and memory, with regions sorted by size over way
class Explorer:
    def __init__(self):
        self.tried = frozenset()
        self.goal = None
        self.why = None

    def read(self):
        self.free, self.occupied, self.frontier = read_map()
        self.edge = find_edge(self.free)
        self.room = find_room(self.free, self.edge)
        self.here = own_cell(self.free, self.room)

    @property
    def way(self):
        worth_it = self.goal is not None and near(self.goal, self.frontier - self.tried)
        return find_way(self.here, self.goal, self.room) if worth_it else []

    def step(self):
        self.read()
        if self.here is None:
            self.why = "the robot has no room"
        elif not self.way:
            self.goal, self.why = choose_goal(self.here, self.frontier, self.room, self.tried)
        elif dist(where(), centre(self.goal)) > 3:
            drive_along(self.way, self.edge)
        else:
            look_round()
            left = read_map()[2]
            self.tried |= {cell for cell in left if dist(cell, self.goal) * CELL < NEAR}

    def run(self):
        look_round()
        while self.why is None and clock() < MAX_TIME:
            self.step()
        return self.why or "time is up"


def choose_goal(here, frontier, room, tried):
    if not frontier:
        return None, "no frontier is left"
    regions = [each for each in find_regions(frontier - tried) if len(each) >= MIN_REGION]
    if not regions:
        return None, "only small frontiers are left"
    steps = {cell: i for i, cell in enumerate(flood(here, room, SIDES))}
    offers = []
    for region in regions:
        spots = [(steps[cell], cell) for cell in steps if near(cell, region)]
        if spots:
            nearest, cell = min(spots)
            offers.append((len(region) / (nearest + 10), cell))
    return (max(offers)[1], None) if offers else (None, "no frontier can be reached")


def explore():
    return Explorer().run()
