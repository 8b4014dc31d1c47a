# style: one size after the other, from the largest down
def large_regions(regions, at_least):
    if not regions:
        return []
    largest = max(map(len, regions))
    return [
        region
        for size in range(largest, at_least - 1, -1)
        for region in regions
        if len(region) == size
    ]
