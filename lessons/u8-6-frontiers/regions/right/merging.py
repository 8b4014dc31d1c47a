# style: groups merged as cells are added
def find_regions(cells):
    groups = []
    for column, row in cells:
        touching = [
            group
            for group in groups
            if any(max(abs(column - c), abs(row - r)) <= 1 for c, r in group)
        ]
        merged = {(column, row)}.union(*touching)
        groups = [group for group in groups if group not in touching] + [merged]
    return groups
