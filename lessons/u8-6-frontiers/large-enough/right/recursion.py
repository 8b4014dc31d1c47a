# style: recursion: sorted as quicksort does
def large_regions(regions, at_least):
    if not regions:
        return []
    first, *others = regions
    size = len(first)
    more = large_regions([each for each in others if len(each) > size], at_least)
    less = large_regions([each for each in others if len(each) <= size], at_least)
    return more + ([first] if size >= at_least else []) + less
