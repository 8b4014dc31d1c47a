# style: filter, and a tuple as the answer

lengths = [i * CELL / 2 for i in range(1000) if i * CELL / 2 < reading - CELL]
cells = tuple(filter(None, (cell_of(*end_of_beam(x, y, angle, length)) for length in lengths)))
