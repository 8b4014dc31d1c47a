# style: conditional expressions

wall = reading < FAR
free = cells_along(x, y, angle, reading - CELL if wall else FAR)
hit = cell_of(*end_of_beam(x, y, angle, reading)) if wall else None
