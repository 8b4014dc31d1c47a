# style: each cell once, and a lookup in place of an if

free = list(dict.fromkeys(cells_along(x, y, angle, [reading - CELL, FAR][reading >= FAR])))
hit = {True: None, False: cell_of(*end_of_beam(x, y, angle, reading))}[reading >= FAR]
