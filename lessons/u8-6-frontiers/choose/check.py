"""nearest_cell(here, region) and choose(here, regions, gain): gain against distance."""

from itertools import pairwise
from math import dist

from grader import calls, check, function, lacks, mistake, reads
from mapping.planning import choose_region


def nearest(here, region):
    return min(region, key=lambda cell: dist(here, cell))


def chosen(
    here, regions, gain, size=len, way=lambda here, region: dist(here, nearest(here, region))
):
    best = choose_region(
        [size(each) for each in regions], [way(here, each) for each in regions], 1, gain
    )
    return None if best is None else nearest(here, regions[best])


def by_worth(worth, nothing=None):
    """What a mistake in a region's worth chooses; `nothing` is what it has to beat, if any."""

    def choose(here, regions, gain):
        best, most = None, nothing
        for region in regions:
            value = worth(len(region), dist(here, nearest(here, region)), gain)
            if most is None or value > most:
                best, most = nearest(here, region), value
        return best

    return choose


def to_the_middle(here, region):
    middle = [sum(each) / len(region) for each in zip(*region)]
    return dist(here, middle)


def on_foot(here, cell):
    return abs(here[0] - cell[0]) + abs(here[1] - cell[1])


nearest_cell = function(
    "nearest_cell(here, region)",
    nearest,
    cell_cm=10,
    leaves=True,
    mistakes=[
        (
            "the region's farthest cell was chosen",
            lambda here, region: max(region, key=lambda cell: dist(here, cell)),
            0,
        ),
        (
            "columns and rows were added up: the distance goes straight, math.dist()",
            lambda here, region: min(region, key=lambda cell: on_foot(here, cell)),
            0,
        ),
        mistake(
            "that is the smallest cell, not the nearest: min() wants a key",
            lambda h, r: min(r),
            0,
            where=calls("min"),
        ),
        (
            "that is the distance: the cell is wanted",
            lambda here, region: min(dist(here, cell) for cell in region),
            0,
        ),
    ],
)
choose = function(
    "choose(here, regions, gain)",
    chosen,
    cell_cm=10,
    leaves=True,
    mistakes=[
        mistake(
            "the size was left out: a region is worth gain times its cells, less the distance",
            lambda here, regions, gain: chosen(here, regions, 0),
            1,
            where=lacks(reads("gain")),
        ),
        (
            "the distance is counted in cells, not in cm: don't multiply it by CELL",
            by_worth(lambda size, apart, gain: gain * size - 10 * apart),
            1,
        ),
        (
            "the distance was left out: the largest region was chosen",
            lambda here, regions, gain: chosen(here, regions, gain, way=lambda here, region: 0),
            1,
        ),
        (
            "distance and gain were left out: the largest region was chosen",
            by_worth(lambda size, apart, gain: size),
            1,
        ),
        (
            "the distance was added: a long route makes a region worth less",
            lambda here, regions, gain: chosen(
                here, regions, gain, way=lambda here, region: -dist(here, nearest(here, region))
            ),
            1,
        ),
        (
            "the distance was measured to the region's middle: its nearest cell counts",
            lambda here, regions, gain: chosen(here, regions, gain, way=to_the_middle),
            2,
        ),
        (
            "gain was left out: each cell of a region is worth gain",
            by_worth(lambda size, apart, gain: size - apart),
            1,
        ),
        (
            "gain is for the cells alone: take the distance away as it is",
            by_worth(lambda size, apart, gain: gain * (size - apart)),
            1,
        ),
        (
            "gain is for the cells, not for the distance: gain * len(region), less the distance",
            by_worth(lambda size, apart, gain: size - gain * apart),
            1,
        ),
        (
            "the distance is taken away, not divided by",
            by_worth(lambda size, apart, gain: gain * size / apart if apart else 1e9),
            1,
        ),
        (
            "a region may be worth less than 0: begin with the first one, not with a worth of 0",
            by_worth(lambda size, apart, gain: gain * size - apart, nothing=0),
            1,
        ),
        (
            "that is the region: its nearest cell is wanted",
            lambda here, regions, gain: (
                max(regions, key=lambda each: gain * len(each) - dist(here, nearest(here, each)))
                if regions
                else None
            ),
            2,
        ),
        (
            "that is the nearest cell of the first region: compare what the regions are worth",
            lambda here, regions, gain: nearest(here, regions[0]) if regions else None,
            1,
        ),
        mistake(
            "the worst region was chosen: what is worth most is wanted, max() and not min()",
            lambda here, regions, gain: chosen(
                here,
                regions,
                -gain,
                way=lambda here, region: -dist(here, nearest(here, region)),
            ),
            2,
            where=calls("min", "sorted", "sort"),
        ),
    ],
)


def some_regions(task, here):
    """Lines of cells that are all at different distances."""
    while True:
        regions = []
        for _ in range(task.random.randrange(2, 6)):
            column, row = task.random.randrange(15), task.random.randrange(20)
            regions.append({(column + i, row) for i in range(task.random.randrange(1, 6))})
        cells = [cell for region in regions for cell in region]
        apart = sorted(dist(here, cell) for cell in cells)
        if all(b - a > 0.01 for a, b in pairwise(apart)):
            return regions


@check("The nearest cell of a region", hint=0)
def one_region(task):
    task.call(nearest_cell, (0, 0), {(5, 0), (4, 4), (3, 3)}, gives=(3, 3))
    task.call(nearest_cell, (7, 7), {(7, 7), (6, 7)}, gives=(7, 7))
    for _ in range(6):
        here = task.random.randrange(20), task.random.randrange(20)
        task.call(nearest_cell, here, some_regions(task, here)[0])


@check("No region, one, or the nearest of two", hint=1)
def few(task):
    near, far = {(10, 6), (10, 7)}, {(2, 15), (3, 15), (4, 15), (5, 15)}
    task.call(choose, (10, 2), [], 1, gives=None)
    task.call(choose, (10, 2), [far], 1, gives=(5, 15))
    task.call(choose, (10, 2), [far, near], 0, gives=(10, 6))
    task.call(choose, (3, 3), [{(5, 3), (6, 3)}, {(3, 3)}], 0, gives=(3, 3))
    task.call(choose, (19, 19), [{(0, 0)}], 2, gives=(0, 0))


@check("A large region against a near one", hint=1)
def gain(task):
    near, far = {(10, 6), (10, 7)}, {(column, 12) for column in range(6, 16)}
    task.call(choose, (10, 2), [near, far], 0.5, gives=(10, 6))
    task.call(choose, (10, 2), [near, far], 1, gives=(10, 12))
    along = {(column, 7) for column in range(10, 20)}
    task.call(choose, (10, 2), [{(4, 2)}, along], 0, gives=(10, 7))


@check("Regions all about", hint=2)
def many(task):
    for _ in range(15):
        here = task.random.randrange(20), task.random.randrange(20)
        gain = round(task.random.uniform(0.1, 3.0), 3)
        task.call(choose, here, some_regions(task, here), gain)
