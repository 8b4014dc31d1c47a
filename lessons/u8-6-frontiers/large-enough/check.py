"""large_regions(regions, at_least): without the small ones, the largest first."""

from grader import calls, check, code, exactly, function, in_any_order, mistake, number


def kept(regions, at_least):
    return [region for region in regions if len(region) >= at_least]


def large(regions, at_least):
    return sorted(kept(regions, at_least), key=len, reverse=True)


def removed_on_the_way(regions, at_least):
    left = list(regions)
    for region in left:
        if len(region) < at_least:
            left.remove(region)
    return large(left, 0)


def one_of_each_size(regions, at_least):
    return large(list({len(region): region for region in regions}.values()), at_least)


def ranked(expected, got):
    """The same regions in the order of their sizes; those of one size may change places."""
    if not isinstance(got, list | tuple) or not isinstance(expected, list | tuple):
        return exactly(expected, got)
    if not all(isinstance(each, set | frozenset) for each in [*expected, *got]):
        return exactly(expected, got)  # sizes in place of regions, say
    return in_any_order(expected, got) and list(map(len, expected)) == list(map(len, got))


large_regions = function(
    "large_regions(regions, at_least)",
    large,
    compare=ranked,
    leaves=True,
    mistakes=[
        (
            "a region of exactly so many cells was left out: at least 5 means 5 or more",
            lambda regions, at_least: large(regions, at_least + 1),
            0,
        ),
        mistake(
            "the order is still that of regions: sets have no order by size, "
            "so sort them with key=len",
            kept,
            2,
            where=code(
                *("sorted(_)", "sorted(_, reverse=True)", "_.sort()", "_.sort(reverse=True)")
            ),
        ),
        ("the order is still that of regions: the largest comes first", kept, 1),
        mistake(
            "a region that is too small is left in: "
            "take nothing out of a list while you walk along it",
            removed_on_the_way,
            1,
            where=calls("remove"),
        ),
        *(
            ("of regions of one size only one is left: all of them are wanted", slip, 1)
            for slip in (
                one_of_each_size,
                lambda regions, at_least: one_of_each_size(regions[::-1], at_least),
            )
        ),
        mistake(
            "the smallest comes first: sorted() goes up, unless it is told reverse=True",
            lambda regions, at_least: large(regions, at_least)[::-1],
            2,
            where=calls("sorted", "sort"),
        ),
        (
            "nothing was left out: only regions of at least so many cells are to stay",
            lambda regions, at_least: large(regions, 0),
            0,
        ),
        (
            "these are the small ones: they are what is to be left out",
            lambda regions, at_least: sorted(
                (region for region in regions if len(region) < at_least), key=len, reverse=True
            ),
            0,
        ),
        (
            "these are sizes: the regions themselves are wanted",
            lambda regions, at_least: [len(region) for region in large(regions, at_least)],
            1,
        ),
        (
            "these are all the cells in one: the regions are wanted, one after the other",
            lambda regions, at_least: set().union(*kept(regions, at_least)),
            1,
        ),
        (
            "only the largest is there: all regions that are large enough are wanted",
            lambda regions, at_least: large(regions, at_least)[:1],
            0,
        ),
        (
            "only the largest is there: all regions that are large enough are wanted, in a list",
            lambda regions, at_least: max(kept(regions, at_least), key=len, default=[]),
            0,
        ),
        mistake(
            "4 was typed in: at_least says how many cells are enough",
            lambda regions, at_least: large(regions, 4),
            0,
            where=number(4),
        ),
    ],
)


def some_regions(task, sizes):
    regions = []
    for row, size in enumerate(sizes):
        first = task.random.randrange(5)
        regions.append({(first + i, 2 * row) for i in range(size)})
    return regions


@check("One just large enough, one just too small", hint=0)
def border(task):
    regions = some_regions(task, [5, 4])
    task.call(large_regions, regions, 5, gives=regions[:1])


@check("The largest first", hint=1)
def order(task):
    task.call(large_regions, some_regions(task, [6, 2, 1, 9, 7]), 5)


@check("Many regions", hint=2)
def many(task):
    task.call(large_regions, [], 5, gives=[])
    for _ in range(8):
        sizes = task.random.sample(range(1, 15), 8)
        task.call(large_regions, some_regions(task, sizes), task.random.randrange(2, 10))


@check("Regions of one size, and of one cell", hint=0)
def equal(task):
    task.call(large_regions, some_regions(task, [5, 7, 5, 3, 7]), 5)
    task.call(large_regions, some_regions(task, [1, 1, 2]), 1)
