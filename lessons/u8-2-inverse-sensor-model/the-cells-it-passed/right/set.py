# style: a set

found = set()
along = 0.0
while along < reading - CELL:
    found.add(cell_of(*end_of_beam(x, y, angle, along)))
    along += CELL / 2
cells = found - {None}
