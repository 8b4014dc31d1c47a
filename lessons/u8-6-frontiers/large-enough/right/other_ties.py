# style: sorted upwards and turned round, so that equal ones change places
def large_regions(regions, at_least):
    return [each for each in reversed(sorted(regions, key=len)) if len(each) >= at_least]
