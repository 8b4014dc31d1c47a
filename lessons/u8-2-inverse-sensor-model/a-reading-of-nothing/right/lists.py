# style: cells as lists, and a list as the answer

free = [list(cell) for cell in cells_along(x, y, angle, FAR if reading >= FAR else reading - CELL)]
hit = None if reading >= FAR else cell_of(*end_of_beam(x, y, angle, reading))
return [free, hit and list(hit)]
