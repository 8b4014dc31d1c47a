# style: the place of each region found by a loop
def large_regions(regions, at_least):
    found = []
    for region in regions:
        if len(region) < at_least:
            continue
        i = 0
        while i < len(found) and len(found[i]) >= len(region):
            i += 1
        found.insert(i, region)
    return found
