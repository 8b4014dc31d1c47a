# style: a class of nodes, lists for cells
from dataclasses import dataclass, field


@dataclass(order=True)
class Node:
    total: float
    cell: tuple = field(compare=False)
    gone: float = field(compare=False)
    parent: object = field(compare=False, default=None)

    def way(self):
        return (self.parent.way() if self.parent else []) + [list(self.cell)]

    def steps(self, room):
        c, r = self.cell
        for i, j in SIDES:
            if (c + i, r + j) in room:
                yield (c + i, r + j), 1.0
        for i, j in CORNERS:
            if all(cell in room for cell in [(c + i, r + j), (c + i, r), (c, r + j)]):
                yield (c + i, r + j), 2**0.5


def find_way(start, goal, room):
    best = {}
    open_nodes = [Node(dist(start, goal), start, 0.0)]
    while open_nodes:
        node = heappop(open_nodes)
        if node.cell == goal:
            return node.way()
        if best.get(node.cell, 1e9) <= node.gone:
            continue
        best[node.cell] = node.gone
        for cell, length in node.steps(room):
            gone = node.gone + length
            heappush(open_nodes, Node(gone + dist(cell, goal), cell, gone, node))
    return []
