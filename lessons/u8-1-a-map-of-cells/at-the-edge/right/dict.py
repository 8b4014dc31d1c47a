# style: a dictionary of all cells

places = {}
for row in range(ACROSS):
    for column in range(ACROSS):
        places[column, row] = len(places)
index = places.get(cell_of(x, y))
