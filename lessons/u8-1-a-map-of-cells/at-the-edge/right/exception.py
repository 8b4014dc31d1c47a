# style: an exception of its own


class Edge(Exception):
    pass


def held(number):
    if not 0 <= number < ACROSS:
        raise Edge
    return number


try:
    column, row = map(held, cell_of(x, y))
    index = row * ACROSS + column
except Edge:
    index = None
