# style: union-find
def find_regions(cells):
    parent = {cell: cell for cell in cells}

    def root(cell):
        while parent[cell] != cell:
            parent[cell] = parent[parent[cell]]
            cell = parent[cell]
        return cell

    for c, r in cells:
        for i, j in SIDES + CORNERS:
            if (c + i, r + j) in parent:
                parent[root((c, r))] = root((c + i, r + j))
    groups = {}
    for cell in cells:
        groups.setdefault(root(cell), set()).add(cell)
    return list(groups.values())
