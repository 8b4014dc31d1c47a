# style: a comprehension

steps = math.ceil((reading - CELL) / (CELL / 2))
return [
    cell
    for i in range(steps)
    if (cell := cell_of(*end_of_beam(x, y, angle, i * CELL / 2))) is not None
]
