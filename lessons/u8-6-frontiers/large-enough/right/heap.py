# style: a heap, and a tuple of frozen sets
from heapq import heapify, heappop


def large_regions(regions, at_least):
    heap = [(-len(region), place) for place, region in enumerate(regions)]
    heapify(heap)
    found = []
    while heap and -heap[0][0] >= at_least:
        found.append(frozenset(regions[heappop(heap)[1]]))
    return tuple(found)
