# style: the largest taken out again and again
def large_regions(regions, at_least):
    left = list(regions)
    found = []
    while left:
        largest = max(left, key=lambda region: len(region))
        left.remove(largest)
        if len(largest) < at_least:
            break
        found.append(largest)
    return found
